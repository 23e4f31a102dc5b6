// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of solvers. The fixtures are a uniform deformation in CalculiX (cases/calculix) and a
// linear velocity in OpenFOAM (cases/openfoam_linear), whose gradients are known.
#include "triplex/io/import_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "temporary_directory.hpp"

namespace triplex::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path kCases = TRIPLEX_CASES_DIR;
const std::filesystem::path kFrd = kCases / "calculix" / "homogeneous.frd";
const std::filesystem::path kFoam = kCases / "openfoam_linear";

Tensor<double> row(const PointValues& array, std::size_t point) {
  EXPECT_EQ(array.components, 9);
  Tensor<double> t;
  std::copy_n(array.values.begin() + static_cast<std::ptrdiff_t>(9 * point), 9, t.begin());
  return t;
}

void expect_near(const Tensor<double>& a, const Tensor<double>& b, double tolerance) {
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "entry " << i;
}

Point times(const Tensor<double>& t, const Point& x) {
  Point y{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) y[i] += t[3 * i + j] * x[j];
  return y;
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Of the fixture, for a load between 0 and 1.
Tensor<double> deformation(double load) {
  return {1 + 0.1 * load, 0.2 * load,  0, -0.1 * load,   1 + 0.05 * load,
          0.3 * load,     0.05 * load, 0, 1 - 0.1 * load};
}

/// The law of the fixture's material: s = 2 C10 J^(-5/3) dev(F F^T) + 2/D1 (J - 1) I.
Tensor<double> neo_hooke(const Tensor<double>& f) {
  constexpr double kC10 = 200, kD1 = 0.002;
  const double j = f[0] * (f[4] * f[8] - f[5] * f[7]) - f[1] * (f[3] * f[8] - f[5] * f[6]) +
                   f[2] * (f[3] * f[7] - f[4] * f[6]);
  Tensor<double> s{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t l = 0; l < 3; ++l) s[3 * i + k] += f[3 * i + l] * f[3 * k + l];
  const double third = (s[0] + s[4] + s[8]) / 3;
  for (const std::size_t d : {0, 4, 8}) s[d] -= third;
  for (double& x : s) x *= 2 * kC10 * std::pow(j, -5.0 / 3);
  for (const std::size_t d : {0, 4, 8}) s[d] += 2 / kD1 * (j - 1);
  return s;
}

constexpr double kDigits = 1e-5;  // six digits are in a .frd file; the gradient divides by 1/2

TEST(CalculiX, RowsAndColumnsAreThoseOfTheDeformationAndTheLaw) {
  for (const double load : {0.5, 1.0}) {
    const ImportedCase result = import_case(kFrd, {.time = 2 * load});
    EXPECT_EQ(result.time, 2 * load);
    EXPECT_EQ(result.field.array_name, "tensor");
    ASSERT_EQ(result.arrays.size(), 3u);
    EXPECT_EQ(result.arrays[0].name, "cauchy");
    EXPECT_EQ(result.arrays[1].name, "F");
    EXPECT_EQ(result.arrays[2].name, "displacement");
    EXPECT_EQ(result.field.split.hexahedra, 8u);
    ASSERT_EQ(result.field.mesh.points.size(), 27u);
    for (std::size_t i = 0; i < 27; ++i) {
      expect_near(row(result.arrays[1], i), deformation(load), kDigits);
      expect_near(row(result.arrays[0], i), neo_hooke(deformation(load)), 1e-2);
    }
  }
}

/// The force on a piece of area: P N dA = s n da, where the edges a, b become F a, F b.
TEST(CalculiX, FirstPiolaKirchhoffStressGivesTheForceOnReferenceAreas) {
  const ImportedCase result = import_case(kFrd);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (std::size_t i = 0; i < result.field.tensors.size(); ++i) {
    const Point a = {number(random), number(random), number(random)};
    const Point b = {number(random), number(random), number(random)};
    const Tensor<double> f = row(result.arrays[1], i);
    const Point reference = times(result.field.tensors[i], cross(a, b));
    const Point deformed = times(row(result.arrays[0], i), cross(times(f, a), times(f, b)));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(reference[c], deformed[c], 1e-10);
  }
}

TEST(CalculiX, TheLastStepIsTakenUnlessATimeIsGiven) {
  EXPECT_EQ(import_case(kFrd).time, 2);
  EXPECT_EQ(import_case(kFrd).field.tensors, import_case(kFrd, {.time = 2}).field.tensors);
}

std::string refusal(const std::filesystem::path& path, const ImportOptions& options = {}) {
  try {
    import_case(path, options);
  } catch (const BadInput& error) {
    EXPECT_THAT(error.what(), testing::StartsWith(path.string() + ": "));
    EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
    return error.what();
  }
  return "accepted";
}

/// The text of the fixture with a part replaced, as a file of its own.
std::string refusal_of(const std::string& part, const std::string& by,
                       std::size_t keep = std::string::npos) {
  const TemporaryDirectory directory;
  std::string text = file_content(kFrd).substr(0, keep);
  if (const auto at = text.find(part); !part.empty() && at != std::string::npos)
    text.replace(at, part.size(), by);
  write_content(directory / "a.frd", text);
  return refusal(directory / "a.frd");
}

TEST(CalculiX, MalformedFilesAreRefusedWithTheLine) {
  EXPECT_EQ(refusal_of("", ""), "accepted");
  const std::size_t end_of_nodes = file_content(kFrd).find("\n -3") + 1;
  EXPECT_THAT(refusal_of("", "", end_of_nodes),
              AllOf(HasSubstr("line "), HasSubstr("the file ends in the block of nodes")));
  EXPECT_THAT(refusal_of("", "", end_of_nodes - 20), HasSubstr("is not a number"));
  EXPECT_THAT(refusal_of(" -1         2 5.00000E-01", " -1         2 5.0000xE-01"),
              AllOf(HasSubstr("line "), HasSubstr("is not a number")));
  EXPECT_THAT(refusal_of(" -1         2 5", " -1         1 5"), HasSubstr("node 1 occurs twice"));
  EXPECT_THAT(refusal_of(" -2         1", " -2        99"), HasSubstr("there is no node 99"));
  EXPECT_THAT(refusal_of(" -1         1    1", " -1         1    7"), HasSubstr("of type 7"));
  EXPECT_THAT(refusal_of(" -4  DISP ", " -4  NONE "),
              HasSubstr("accepted"));  // another step has it
  EXPECT_THAT(refusal_of(" -4  DISP ", " -7  DISP "), HasSubstr("unexpected record"));
  EXPECT_THAT(refusal_of("27                                     1",
                         "27                                     2"),
              HasSubstr("is not ASCII"));
  EXPECT_THAT(refusal_of("    2C", "    9C"), HasSubstr("there is no node 1"));
  EXPECT_THAT(refusal_of("    1C", " 9999"), HasSubstr("no block of nodes"));
  EXPECT_THAT(refusal(kFrd, {.time = 3}), AllOf(HasSubstr("no time 3"), HasSubstr("1, 2")));
  EXPECT_THAT(refusal(kFrd, {.gradient_of = "U"}), HasSubstr("are for OpenFOAM"));
}

/// One element at unit coordinates, displaced by (0, x, 0), with STRESS.
std::string element_frd(int type, const std::vector<Point>& nodes) {
  const auto number = [](double x) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%12.5E", x);
    return std::string(text.data());
  };
  const auto id = [](std::size_t i) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%10zu", i);
    return std::string(text.data());
  };
  const auto line = [&](std::size_t i, const std::vector<double>& values) {
    std::string text = " -1" + id(i);
    for (const double x : values) text += number(x);
    return text + "\n";
  };
  std::string text = "    2C 1\n", disp, stress;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    text += line(i + 1, {nodes[i].begin(), nodes[i].end()});
    disp += line(i + 1, {0, nodes[i][0], 0});
    stress += line(i + 1, {1, 2, 3, 4, 5, 6});
  }
  text += " -3\n    3C 1\n -1" + id(1) + "    " + std::to_string(type) + "    0    1\n -2";
  for (std::size_t i = 1; i <= nodes.size(); ++i) {
    text += id(i);
    if (i % 10 == 0 && i < nodes.size()) text += "\n -2";
  }
  const std::string head =
      "\n -3\n  100CL  101 1.000000000           4                     0    1           1\n";
  return text + head + " -4  DISP        4    1\n" + disp + " -3" + head +
         " -4  STRESS      6    1\n" + stress + " -3\n 9999\n";
}

TEST(CalculiX, EveryKindOfSolidElementIsTakenByItsCorners) {
  const std::vector<Point> tet = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<Point> tet10 = tet;
  for (const auto& [a, b] : std::vector<std::pair<std::size_t, std::size_t>>{
           {0, 1}, {1, 2}, {0, 2}, {0, 3}, {1, 3}, {2, 3}})
    tet10.push_back(
        {(tet[a][0] + tet[b][0]) / 2, (tet[a][1] + tet[b][1]) / 2, (tet[a][2] + tet[b][2]) / 2});
  const std::vector<Point> wedge = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {0, 1, 1}};
  std::vector<Point> wedge15 = wedge;
  for (int i = 0; i < 9; ++i) wedge15.push_back({0.1 * i, 0.2, 0.3});
  const std::vector<Point> brick = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::vector<Point> brick20 = brick;
  for (int i = 0; i < 12; ++i) brick20.push_back({0.05 * i, 0.2, 0.3});
  struct Kind {
    int type;
    std::vector<Point> nodes;
    std::size_t points, tets;
  };
  for (const Kind& kind : {Kind{3, tet, 4, 1}, Kind{6, tet10, 4, 1}, Kind{2, wedge, 6, 3},
                           Kind{5, wedge15, 6, 3}, Kind{1, brick, 8, 6}, Kind{4, brick20, 8, 6}}) {
    const TemporaryDirectory directory;
    write_content(directory / "a.frd", element_frd(kind.type, kind.nodes));
    const ImportedCase result = import_case(directory / "a.frd");
    EXPECT_EQ(result.field.mesh.points.size(), kind.points) << kind.type;
    EXPECT_EQ(result.field.mesh.tets.size(), kind.tets) << kind.type;
    for (std::size_t i = 0; i < kind.points; ++i) {
      expect_near(row(result.arrays[1], i), {1, 0, 0, 1, 1, 0, 0, 0, 1}, 1e-12);
      expect_near(row(result.arrays[0], i), {1, 4, 6, 4, 2, 5, 6, 5, 3}, 0);
    }
  }
}

/// The fixture's velocity is G x.
constexpr Tensor<double> kGradient = {1, 2, -3, 0.5, -2, 4, -1, 0.25, 1};

/// Points that no boundary touches: there the means of cells are exact for a linear field.
bool is_inside(const Point& x) {
  constexpr double kEdge = 0.1;
  return x[0] > kEdge && x[0] < 2 - kEdge && x[1] > kEdge && x[1] < 1 - kEdge && x[2] > kEdge &&
         x[2] < 1 - kEdge;
}

TEST(OpenFoam, ItsGradientIsTheTransposeOfOurs) {
  const ImportedCase result = import_case(kFoam, {.tensor_name = "grad(U)"});
  EXPECT_EQ(result.time, 1);
  EXPECT_EQ(result.field.split.hexahedra, 54u);
  ASSERT_EQ(result.field.tensors.size(), 7u * 4 * 4);
  for (const Tensor<double>& t : result.field.tensors) expect_near(t, kGradient, 1e-5);
}

TEST(OpenFoam, TheGradientOfTheVelocityAgrees) {
  const ImportedCase result = import_case(kFoam);
  ASSERT_EQ(result.arrays.size(), 1u);
  EXPECT_EQ(result.arrays[0].name, "velocity");
  int inside = 0;
  for (std::size_t i = 0; i < result.field.tensors.size(); ++i) {
    const Point& x = result.field.mesh.points[i];
    if (!is_inside(x)) continue;
    ++inside;
    const Point u = times(kGradient, x);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(result.arrays[0].values[3 * i + c], u[c], 1e-5);
  }
  EXPECT_EQ(inside, 5 * 2 * 2);
}

TEST(OpenFoam, WhatIsNoCaseIsRefused) {
  const TemporaryDirectory directory;
  EXPECT_THAT(refusal(directory / ""), HasSubstr("no system/controlDict"));
  EXPECT_THAT(refusal(directory / "missing.frd"), HasSubstr("no such file"));
  write_content(directory / "a.txt", "text");
  EXPECT_THAT(refusal(directory / "a.txt"), HasSubstr("CalculiX .frd"));
  EXPECT_THAT(refusal(kFoam, {.time = 7}), AllOf(HasSubstr("no time 7"), HasSubstr("1")));
  EXPECT_THAT(refusal(kFoam, {.gradient_of = "V"}), HasSubstr("no point array V"));
  EXPECT_THAT(refusal(kFoam, {.gradient_of = "U", .tensor_name = "grad(U)"}),
              HasSubstr("leave one out"));
}

}  // namespace
}  // namespace triplex::test
