// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "triplex/extract/extraction.hpp"

namespace triplex::cli {

/// The keys `identical` and `unresolved` of report.json.
nlohmann::ordered_json identical_json(const IdenticalSimplices& identical);
nlohmann::ordered_json unresolved_json(const Extraction& extraction);

/// Lines for people on what vanishes identically on tets, faces or edges; empty if nothing does.
std::string identical_lines(const IdenticalSimplices& identical);

}  // namespace triplex::cli
