// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "triplex/feature/feature_soup.hpp"
#include "triplex/feature/feature_table.hpp"
#include "triplex/field/progress.hpp"

namespace triplex {

/// Which pairs of features may meet away from common vertices and edges.
class CrossingPolicy {
 public:
  /// None may: neither within one feature nor between two.
  CrossingPolicy() = default;
  /// As the theory has it: a level set may cross pages, the triple curve and other level sets;
  /// pages meet on the triple curve and at nodes only, and nothing crosses itself.
  explicit CrossingPolicy(const FeatureTable& table);

  void allow(Feature a, Feature b) {
    allowed_[index(a)] |= bit(b);
    allowed_[index(b)] |= bit(a);
  }
  bool allows(Feature a, Feature b) const { return contains(allowed_[index(a)], b); }

 private:
  std::array<FeatureSet, kMaxFeatures> allowed_{};
};

/// How two cells meet where they have no common vertex or edge.
enum class ContactKind : std::uint8_t {
  Crossing,  ///< the inside of an edge of one passes through the inside of the other, a triangle
  Overlap,   ///< in one plane, with a common part that has an area; or segments on one line
  Touching,  ///< otherwise: a vertex or an edge of one on the other, no edge passes through
};
inline constexpr int kContactKinds = 3;
/// "crossing", "overlap", "touching".
std::string_view name_of(ContactKind kind);

/// Two cells that have more in common than their common vertices and edges.
struct Contact {
  std::uint32_t first, second;  ///< cells, first < second
  ContactKind kind;
  std::uint8_t shared;  ///< vertices that both have: 0 to 3

  friend bool operator==(const Contact&, const Contact&) = default;
};

struct EmbeddingOptions {
  CrossingPolicy policy = {};
  /// The triple curve is among the segments: features that may not meet may share vertices on it
  /// and at nodes only. Otherwise nobody knows where it is, and they may share any.
  bool has_triple_curve = false;
  /// Contacts beyond these are counted but not listed.
  std::size_t most_listed = 1'000'000;
  /// Also list the pairs of triangles that the policy allows to meet and that do.
  bool list_crossings = false;
  std::function<void(double)> progress = {};  ///< from 0 to 1, from one thread
  /// Set to true from anywhere to stop; `check_embedding` then throws `Interrupted`.
  const std::atomic<bool>* interrupted = nullptr;
};

struct EmbeddingResult {
  std::vector<Contact> contacts;   ///< ascending by cells; the first `most_listed`
  std::vector<Contact> crossings;  ///< allowed pairs of triangles, ascending; all
  /// Triangles without area and segments without length, ascending. They are in no contact.
  std::vector<std::uint32_t> degenerate;
  /// With `has_triple_curve`: vertices, by their lowest points, off that curve and no nodes, that
  /// two features share which may not meet. Ascending.
  std::vector<std::uint32_t> joined;
  std::uint64_t vertices = 0;  ///< points that are used, equal ones counted once
  std::uint64_t pairs = 0;     ///< pairs of cells whose boxes meet: those decided
  /// All contacts, by kind: within one feature, and between two that may not meet.
  std::array<std::uint64_t, kContactKinds> within{}, between{};

  std::uint64_t contacts_within() const { return within[0] + within[1] + within[2]; }
  std::uint64_t contacts_between() const { return between[0] + between[1] + between[2]; }
  /// No contact, nothing degenerate, nothing joined.
  bool embedded() const {
    return contacts_within() + contacts_between() == 0 && degenerate.empty() && joined.empty();
  }
};

/// Decides for all pairs of cells whether they meet in more than a common vertex or edge.
/// Coordinates are taken as exact. Guarantee: `embedded()` if and only if no cell is degenerate and
/// any two that the policy keeps apart meet in a common face of both, or not at all, and share
/// vertices where they may; every listed contact is one. The result does not depend on threads.
/// Cost: near linear in the cells where they are small; memory linear in cells and contacts. \throw
/// std::invalid_argument as `check_mesh`, and unless there is one feature per cell; Interrupted.
/// Source: proofs/embedding.md.
EmbeddingResult check_embedding(const FeatureSoup& soup, const EmbeddingOptions& options = {});

}  // namespace triplex
