// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "feature_list.hpp"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <charconv>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace triplex::cli {
namespace {

constexpr std::string_view kNone = "none";

std::string standard_names() {
  return fmt::format("{}", fmt::join(names_of(FeatureTable(), kStandardSet), ","));
}

FeatureSet parse_names(const std::vector<std::string>& names) {
  const FeatureTable standard;
  FeatureSet set = 0;
  for (const std::string& name : names) {
    if (name == kNone && names.size() == 1) return 0;
    const auto feature = standard.named(name);
    if (!feature)
      throw UsageError(fmt::format("--features: no feature is called '{}'; there are {}, or {}",
                                   name, standard_names(), kNone));
    set |= bit(*feature);
  }
  return set;
}

[[noreturn]] void fail_mode(const std::string& text, std::string_view reason) {
  throw UsageError(fmt::format(
      "--mode {}: {}; give MU,SIGN_P,SIGN_Q, as in 1/2,-,+ (MU a fraction, a decimal or inf)", text,
      reason));
}

/// Digits only, of at most 9 places: no overflow.
std::uint32_t parse_digits(std::string_view digits, const std::string& text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || digits.size() > 9)
    fail_mode(text, fmt::format("'{}' is no number of at most 9 digits", digits));
  return value;
}

/// A fraction, a decimal or inf, exactly.
ModeRatio parse_ratio(std::string_view mu, const std::string& text) {
  if (mu == "inf") return {1, 0};
  if (const auto slash = mu.find('/'); slash != std::string_view::npos)
    return {parse_digits(mu.substr(0, slash), text), parse_digits(mu.substr(slash + 1), text)};
  const auto point = mu.find('.');
  if (point == std::string_view::npos) return {parse_digits(mu, text), 1};
  const std::string digits = std::string(mu.substr(0, point)) + std::string(mu.substr(point + 1));
  ModeRatio ratio{parse_digits(digits, text), 1};
  for (std::size_t k = point + 1; k < mu.size(); ++k) ratio.denominator *= 10;
  return ratio;
}

Sign parse_sign(std::string_view sign, const std::string& text) {
  if (sign == "+") return Sign::Positive;
  if (sign == "-") return Sign::Negative;
  if (sign == "0") return Sign::Zero;
  fail_mode(text, fmt::format("'{}' is no sign: +, - or 0", sign));
}

Feature add_mode(FeatureTable& table, const std::string& text) {
  const auto first = text.find(','), last = text.rfind(',');
  if (first == std::string::npos || first == last) fail_mode(text, "two commas are needed");
  const std::string_view view = text;
  return table.add_mode(parse_ratio(view.substr(0, first), text),
                        parse_sign(view.substr(first + 1, last - first - 1), text),
                        parse_sign(view.substr(last + 1), text));
}

}  // namespace

RequestedFeatures resolve(const FeatureRequest& request) {
  RequestedFeatures requested;
  if (!request.names.empty()) requested.set = parse_names(request.names);
  FeatureTable& table = requested.table;
  try {
    for (const std::string& mode : request.modes) requested.set |= bit(add_mode(table, mode));
    for (const double s : request.magnitudes) requested.set |= bit(table.add_magnitude(s));
    for (const double eta : request.isotropicities)
      requested.set |= bit(table.add_isotropicity(eta));
    if (request.traceless) requested.set |= bit(table.add_traceless());
  } catch (const BadFeature& error) {
    throw UsageError(error.what());
  }
  if (requested.set == 0) throw UsageError("--features none: and no other feature is asked for");
  return requested;
}

void add_feature_options(CLI::App& command, FeatureRequest& request) {
  command
      .add_option("--features", request.names,
                  "Only these, of " + standard_names() + "; or none, but what other options add")
      ->delimiter(',')
      ->type_name("A,B,...");
  command
      .add_option("--mode", request.modes,
                  "Also the mode surface MU with these signs of p and q, as in 1/2,-,+; repeatable")
      ->type_name("MU,SIGN_P,SIGN_Q")
      ->expected(1)
      ->take_all();
  command.add_option("--magnitude", request.magnitudes, "Also the surface |T| = S; repeatable")
      ->type_name("S")
      ->expected(1)
      ->take_all();
  command
      .add_option("--isotropicity", request.isotropicities,
                  "Also the surface tr(T) = sqrt(3) ETA |T|, -1 < ETA < 1; repeatable")
      ->type_name("ETA")
      ->expected(1)
      ->take_all();
  command.add_flag("--traceless", request.traceless, "Also the surface tr(T) = 0");
}

void add_to_json(const FeatureRequest& request, nlohmann::ordered_json& options) {
  const RequestedFeatures all = resolve(request);
  options["features"] = names_of(all.table, all.set);
  options["modes"] = request.modes;
  options["magnitudes"] = request.magnitudes;
  options["isotropicities"] = request.isotropicities;
  options["traceless"] = request.traceless;
}

FeatureRequest feature_request_from(const nlohmann::ordered_json& options) {
  FeatureRequest request;
  for (const std::string name : options.at("features"))
    if (standard_features().named(name)) request.names.push_back(name);
  if (request.names.empty()) request.names.emplace_back(kNone);
  options.at("modes").get_to(request.modes);
  options.at("magnitudes").get_to(request.magnitudes);
  options.at("isotropicities").get_to(request.isotropicities);
  options.at("traceless").get_to(request.traceless);
  return request;
}

std::vector<Feature> reading_order(FeatureSet set) {
  std::vector<Feature> order = {Feature::DegenerateLinear, Feature::DegeneratePlanar,
                                Feature::NeutralReal,      Feature::NeutralComplex,
                                Feature::BalancedLinear,   Feature::BalancedPlanar,
                                Feature::TripleCurve};
  for (int n = kStandardFeatures; n < kMaxFeatures; ++n) order.push_back(static_cast<Feature>(n));
  std::erase_if(order, [set](Feature f) { return !contains(set, f); });
  return order;
}

std::vector<std::string_view> names_of(const FeatureTable& table, FeatureSet set) {
  std::vector<std::string_view> names;
  for (const Feature f : reading_order(set)) names.push_back(table.row(f).name);
  return names;
}

}  // namespace triplex::cli
