// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sub_tet.hpp"
#include "tet_polynomial.hpp"
#include "triplex/feature/sheet.hpp"

namespace triplex::baseline {

/// Bernstein coefficients of 2 P'^3 + 3 Q'^2 with the forms P' and Q' that the map gives.
Coefficients<4, 6> sextic_coefficients(const Forms<double, 4>& forms, const ModeMap& map);
/// Of |T|^2 - s^2, of tr(T)^2 - 3 eta^2 |T|^2, and of tr(T).
Coefficients<4, 2> magnitude_coefficients(const std::array<FieldPoint, 4>& v, double s);
Coefficients<4, 2> isotropicity_coefficients(const std::array<FieldPoint, 4>& v, double eta);
Coefficients<4, 1> trace_coefficients(const std::array<FieldPoint, 4>& v);

}  // namespace triplex::baseline
