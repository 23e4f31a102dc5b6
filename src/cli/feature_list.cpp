// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_list.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "command.hpp"

namespace triplex::cli {

FeatureSet parse_features(const std::vector<std::string>& names) {
  FeatureSet set = 0;
  for (const std::string& name : names) {
    const auto feature = feature_named(name);
    if (!feature) {
      throw UsageError(fmt::format("--features: no feature is called '{}'; there are {}", name,
                                   all_feature_names()));
    }
    set = static_cast<FeatureSet>(set | bit(*feature));
  }
  return set;
}

std::string all_feature_names() {
  return fmt::format("{}", fmt::join(names_of(kAllFeatures), ","));
}

std::vector<std::string_view> names_of(FeatureSet set) {
  std::vector<std::string_view> names;
  for (const Feature f : kReadingOrder) {
    if (contains(set, f)) names.push_back(row(f).name);
  }
  return names;
}

}  // namespace triplex::cli
