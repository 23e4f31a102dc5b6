// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "update_in_one_thread.hpp"

#include <vtkAlgorithm.h>
#include <vtkSMPTools.h>

#include <string>

namespace triplex::detail {

void update_in_one_thread(vtkAlgorithm& filter) {
  vtkSMPTools::LocalScope(vtkSMPTools::Config(std::string("Sequential")), [&] { filter.Update(); });
}

}  // namespace triplex::detail
