// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "triplex/arithmetic/sign.hpp"
#include "triplex/bernstein/tensor_array.hpp"

namespace triplex {

/// The sign of (b-a) x (c-a) . (d-a): positive for the tets of a `TetMesh`.
/// Guarantee: exact for all finite doubles (filtered, then exact). \pre all coordinates are finite.
Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d);

}  // namespace triplex
