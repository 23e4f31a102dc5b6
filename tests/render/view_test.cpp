// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/render/view.hpp"

#include <gtest/gtest.h>

#include "triplex/render/color.hpp"
#include "triplex/render/render.hpp"

namespace triplex::test {
namespace {

TEST(View, PresetsLieOnTheirAxes) {
  EXPECT_EQ(view_named("x")->from, (std::array<double, 3>{1, 0, 0}));
  EXPECT_EQ(view_named("-y")->from, (std::array<double, 3>{0, -1, 0}));
  EXPECT_EQ(view_named("-z")->from, (std::array<double, 3>{0, 0, -1}));
  EXPECT_EQ(view_named("diagonal")->name, "diagonal");
  for (const char* const wrong : {"", "-", "w", "xx", "X", "--x", "-diagonal"})
    EXPECT_FALSE(view_named(wrong)) << wrong;
}

TEST(View, AnglesCountFromTheAxes) {
  for (const auto& [azimuth, elevation, name] :
       {std::tuple{0.0, 0.0, "x"}, {90.0, 0.0, "y"}, {180.0, 0.0, "-x"}, {0.0, 90.0, "z"}}) {
    const auto from = view_of_angles(azimuth, elevation).from;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(from[k], view_named(name)->from[k], 1e-15) << name;
  }
}

TEST(Color, NamesOfTheWebAndHexadecimalNumbers) {
  EXPECT_EQ(color_named("white"), (Color{1, 1, 1}));
  EXPECT_EQ(color_named("#ff0080"), (Color{1, 0, 128 / 255.0}));
  for (const char* const wrong : {"", "no colour", "#ff00", "#gg0000", "ff0000"})
    EXPECT_FALSE(color_named(wrong)) << wrong;
}

TEST(SheetOfGroups, HasAGroupForEachPairThatIsWanted) {
  EXPECT_EQ(sheet_of_groups(kStandardSet).size(), 4u);
  const auto groups = sheet_of_groups(bit(Feature::BalancedPlanar) | bit(Feature::TripleCurve));
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_EQ(groups[0].features, groups[1].features);
  EXPECT_EQ(groups[1].title, "balanced surfaces");
  EXPECT_EQ(sheet_of_groups(bit(Feature::TripleCurve)).size(), 1u);
}

}  // namespace
}  // namespace triplex::test
