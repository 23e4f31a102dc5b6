// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `triplex info` finds in fields whose degeneracies are put there.
#include <gmock/gmock.h>

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>

#include "../oracle/random_tensors.hpp"
#include "run_program.hpp"
#include "triplex/field/grid.hpp"
#include "triplex/io/write_field.hpp"

namespace triplex::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr Tensor<double> kNode = {2, 7, 5, 0, -1, 0, 0, 0, -1};
constexpr Tensor<double> kJordan = {0, 1, 0, 0, 0, 1, 0, 0, 0};
constexpr Tensor<double> kRankOne = {1, -1, 0, 1, -1, 0, 0, 0, 0};
constexpr Tensor<double> kIdentity = {3, 0, 0, 0, 3, 0, 0, 0, 3};

using Formula = std::function<Tensor<double>(std::size_t vertex)>;

TensorField make(int n, const Formula& formula, double jitter = 0) {
  GridOptions options;
  options.n = n;
  options.jitter = jitter;
  TensorField field;
  field.mesh = grid_mesh(options, Box{{0, 0, 0}, {1, 1, 1}});
  field.array_name = "tensor";
  for (std::size_t v = 0; v < field.mesh.points.size(); ++v) field.tensors.push_back(formula(v));
  return field;
}

Outcome info(const TensorField& field, const std::vector<std::string>& more) {
  const TemporaryDirectory directory;
  const std::string file = (directory / "field.vtu").string();
  write_field(file, field);
  std::vector<std::string> words = {"info", file};
  words.insert(words.end(), more.begin(), more.end());
  Outcome outcome = run(words);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  return outcome;
}

json about(const TensorField& field) { return json::parse(info(field, {"--json"}).out); }

std::vector<std::string> warnings(const Formula& formula) {
  return about(make(2, formula))["warnings"].get<std::vector<std::string>>();
}

TEST(Info, CountsExactKinds) {
  // 27 vertices: 0 to 8 as listed, then symmetric but generic, then generic.
  const json info = about(make(2, [](std::size_t v) -> Tensor<double> {
    if (v < 2) return kNode;
    if (v < 5) return kJordan;
    if (v < 6) return kRankOne;
    if (v < 8) return kIdentity;
    if (v < 9) return {};
    if (v < 13) return {1, 2, 3, 2, static_cast<double>(v), 5, 3, 5, 7};
    return {static_cast<double>(v), 2, 3, -4, 5, 6, 7, 8, 9};
  }));
  const json& kinds = info["exact_kinds"];
  EXPECT_EQ(kinds["nodes"], 2);
  EXPECT_EQ(kinds["rank_one_deviators"], 1);
  EXPECT_EQ(kinds["multiples_of_identity"], 3);
  EXPECT_EQ(kinds["triple_degenerate"], 3 + 1 + 3);
  EXPECT_EQ(kinds["symmetric"], 3 + 4);
  EXPECT_EQ(info["exact_zeros"]["tensor"], 1);
  EXPECT_EQ(info["exact_zeros"]["trace"], 2 + 3 + 1 + 1);
  EXPECT_EQ(info["exact_zeros"]["discriminant"], 2 + 7);
  EXPECT_EQ(info["on_features"], 9);
  EXPECT_THAT(info["warnings"].get<std::vector<std::string>>(), IsEmpty());
}

TEST(Info, RangesLeaveOutWhatIsUndefined) {
  const json info = about(make(2, [](std::size_t v) -> Tensor<double> {
    if (v == 0) return {};                            // no isotropicity, no mode
    if (v == 1) return {0, 1, 0, 0, 0, 1, 1, 0, 0};   // balanced
    if (v == 2) return {1, 0, 0, 0, 1, 0, 0, 0, -2};  // mode 1, isotropicity 0
    return {0, -1, 0, 1, 0, 0, 0, 0, 0};              // mode 0
  }));
  EXPECT_EQ(info["mode"], json::parse("[0, 1]"));
  EXPECT_EQ(info["isotropicity"], json::parse("[0, 0]"));
  const json zero = about(make(1, [](std::size_t) { return Tensor<double>{}; }));
  EXPECT_TRUE(zero["mode"].is_null());
  EXPECT_TRUE(zero["isotropicity"].is_null());
  EXPECT_EQ(zero["magnitude"], json::parse("[0, 0]"));
}

// Six times the volume of a tet.
double volume(const TensorField& field, const std::array<VertexId, 4>& tet) {
  std::array<Point, 3> e;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      e[k][axis] =
          field.mesh.points[index(tet[k + 1])][axis] - field.mesh.points[index(tet[0])][axis];
    }
  }
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += e[0][i] * (e[1][j] * e[2][k] - e[1][k] * e[2][j]);
  }
  return sum;
}

// One vertex of one label among others: its share is a quarter of the volume of its tets.
TEST(Info, SharesOfTheVolume) {
  const auto formula = [](std::size_t v) -> Tensor<double> {
    if (v == 21) return {3, 0, 0, 0, -1, 0, 0, 0, -2};
    if (v == 42) return {};
    return {2, 0, 0, 0, 1, 0, 0, 0, -3};
  };
  const TensorField field = make(3, formula, 0.4);
  double whole = 0;
  std::array<double, 2> around{};
  for (const auto& tet : field.mesh.tets) {
    whole += volume(field, tet);
    for (const VertexId v : tet) {
      if (index(v) == 21) around[0] += volume(field, tet) / 4;
      if (index(v) == 42) around[1] += volume(field, tet) / 4;
    }
  }
  const json shares = about(field)["domain_volume_approx"];
  EXPECT_NEAR(shares["real-linear"], around[0] / whole, 1e-12);
  EXPECT_NEAR(shares["on_features"], around[1] / whole, 1e-12);
  double sum = 0;
  for (const auto& [name, share] : shares.items()) sum += share.get<double>();
  EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(Info, CountsConstantTetsAndFacesOnce) {
  // Vertices of two kinds: count what has one kind only, each face once, from the mesh itself.
  const auto kind = [](std::size_t v) {
    const std::size_t scattered = v * 2654435761 >> 16;
    return static_cast<int>(std::max<std::size_t>(scattered % 4, 1)) - 1;
  };
  const TensorField field = make(12, [&](std::size_t v) -> Tensor<double> {
    if (kind(v) == 0) return {};
    return {static_cast<double>(kind(v)), 1, 2, 3, 4, 5, 6, 7, 8};
  });
  std::size_t tets = 0, vanishing = 0;
  std::set<std::set<std::size_t>> faces;
  for (const auto& tet : field.mesh.tets) {
    std::set<int> kinds;
    for (const VertexId v : tet) kinds.insert(kind(index(v)));
    tets += static_cast<std::size_t>(kinds.size() == 1);
    vanishing += static_cast<std::size_t>(kinds == std::set<int>{0});
    for (const VertexId left_out : tet) {
      std::set<std::size_t> face;
      std::set<int> face_kinds;
      for (const VertexId v : tet) {
        if (v == left_out) continue;
        face.insert(index(v));
        face_kinds.insert(kind(index(v)));
      }
      if (face_kinds.size() == 1) faces.insert(face);
    }
  }
  ASSERT_GT(vanishing, 0);
  const json constant = about(field)["constant"];
  EXPECT_EQ(constant["tets"], tets);
  EXPECT_EQ(constant["vanishing_tets"], vanishing);
  EXPECT_EQ(constant["faces"], faces.size());
  EXPECT_THAT(
      about(field)["warnings"].get<std::vector<std::string>>(),
      Contains(HasSubstr("all tensors of " + std::to_string(vanishing) + " tets are zero")));
}

TEST(Info, WarnsOfWhatLooksDegenerate) {
  const auto varied = [](std::size_t v) { return 1 + static_cast<double>(v); };
  EXPECT_THAT(warnings([](std::size_t) { return Tensor<double>{}; }),
              AllOf(Contains("every tensor is zero"), Not(Contains(HasSubstr("symmetric")))));
  EXPECT_THAT(warnings([](std::size_t) { return kNode; }),
              AllOf(Contains(HasSubstr("constant in every tet")), Contains(HasSubstr("D = 0"))));
  EXPECT_THAT(warnings([&](std::size_t v) -> Tensor<double> {
                return {varied(v), 0, 0, 0, varied(v), 0, 0, 0, varied(v)};
              }),
              Contains(HasSubstr("multiple of the identity")));
  EXPECT_THAT(warnings([&](std::size_t v) {
                Tensor<double> t = kJordan;
                t[1] = varied(v);
                return t;
              }),
              Contains(HasSubstr("triple degenerate")));
  EXPECT_THAT(warnings([&](std::size_t v) -> Tensor<double> {
                return {0, varied(v), 0, 0, 0, 1, 1, 0, 0};
              }),
              Contains(HasSubstr("balanced")));
  EXPECT_THAT(warnings([&](std::size_t v) -> Tensor<double> {
                return {1, varied(v), 2, varied(v), 5, 3, 2, 3, 9};
              }),
              Contains(HasSubstr("every tensor is symmetric")));
  EXPECT_THAT(warnings([&](std::size_t v) -> Tensor<double> {
                return {0, varied(v), 2, -varied(v), 0, 3, -2, -3, 0};
              }),
              AllOf(Contains("every tensor is antisymmetric"), Contains(HasSubstr("q = 0"))));
  EXPECT_THAT(warnings([&](std::size_t v) -> Tensor<double> {
                return {1, 0, varied(v), 0, 0, 0, 2, 0, 3};
              }),
              AllOf(Contains(HasSubstr("planar: row and column y")),
                    Not(Contains(HasSubstr("column x"))), Not(Contains(HasSubstr("column z")))));
}

TEST(Info, IsNotPlanarByARowAlone) {
  EXPECT_THAT(warnings([](std::size_t v) -> Tensor<double> {
                return {1, static_cast<double>(v), 2, 0, 0, 0, 3, 4, 5};
              }),
              IsEmpty());
}

TEST(Info, WarnsOfRounding) {
  oracle::Random random(1);
  const auto generic = [&](std::size_t) {
    Tensor<double> t = oracle::double_tensor(random);
    t[8] = -t[0] - t[4];
    return t;
  };
  EXPECT_THAT(warnings([&](std::size_t v) {
                Tensor<double> t = generic(v);
                t[8] += 1e-14;
                return t;
              }),
              Contains(HasSubstr("trace is at the level of rounding")));
  EXPECT_THAT(warnings([&](std::size_t v) {
                Tensor<double> t = generic(v);
                t[8] += 1e-6;
                return t;
              }),
              IsEmpty());
  EXPECT_THAT(warnings([&](std::size_t v) {
                Tensor<double> t = generic(v);
                t[8] += 1;
                t[3] = t[1] + 1e-14;
                t[6] = t[2];
                t[7] = t[5];
                return t;
              }),
              Contains(HasSubstr("symmetric up to rounding")));
}

TEST(Info, TextSaysTheSame) {
  const TensorField field = make(2, [](std::size_t v) { return v < 9 ? kNode : kJordan; });
  const Outcome outcome = info(field, {});
  for (const char* const text : {"isotropicity", "mode, where finite", "(sampled)",
                                 "node                            9    33.33 %",
                                 "p = q = 0                      18    66.67 %",
                                 "warning: every tensor is degenerate: D = 0"}) {
    EXPECT_THAT(outcome.out, HasSubstr(text));
  }
}

TEST(Info, EqualRunsGiveEqualText) {
  oracle::Random random(2);
  const TensorField field = make(16, [&](std::size_t) { return oracle::double_tensor(random); });
  const auto without_name = [](json j) {
    j.erase("file");
    return j.dump();
  };
  const std::string first = without_name(about(field));
  for (int n = 0; n < 4; ++n) EXPECT_EQ(without_name(about(field)), first);
}

}  // namespace
}  // namespace triplex::test
