// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace triplex {

/// The input is unusable. `what()` is one line that names the entity at fault (id, place, value)
/// and the cure; the io layer puts the name of the file in front.
class BadInput : public std::runtime_error {
 public:
  explicit BadInput(const std::string& message) : std::runtime_error(message) {}
};

}  // namespace triplex
