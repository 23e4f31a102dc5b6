// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class vtkAlgorithm;

namespace triplex::detail {

/// Runs a filter without VTK's threads. In threads VTK lists the cells at a point in any order, and
/// sums over them round otherwise from run to run.
void update_in_one_thread(vtkAlgorithm& filter);

}  // namespace triplex::detail
