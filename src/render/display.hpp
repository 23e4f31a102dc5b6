// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace triplex {

/// Errors: no X display can be opened -> RenderError that names the cure. VTK would abort the
/// process.
void require_display();

}  // namespace triplex
