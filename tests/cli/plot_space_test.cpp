// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex plot-space`, under a virtual X server.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "picture.hpp"
#include "virtual_display.hpp"

namespace triplex::test {
namespace {

using testing::HasSubstr;

class PlotSpace : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_virtual_display()) GTEST_SKIP() << "needs xvfb-run (packages xvfb and xauth)";
  }
  Picture draw(std::vector<std::string> options) {
    const std::string file = (directory_ / "space.png").string();
    options.insert(options.begin(), "plot-space");
    options.insert(options.end(), {"-o", file, "--size", "480x240"});
    const Outcome outcome = run_on_virtual_display(options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Picture(file);
  }
  TemporaryDirectory directory_;
};

const HasHue kBrown{27, 6, 0.7}, kPink{342, 6, 0.25};

TEST_F(PlotSpace, HasThePaperColoursInBothPanels) {
  const Picture both = draw({});
  for (const HasHue& hue : {kGreen, kYellow, kOrange, kRed, kBlue, kMagenta}) {
    EXPECT_GT(both.count(hue, 0, 0.5), 15) << hue.hue;
    EXPECT_GT(both.count(hue, 0.5, 1), 5) << hue.hue;
  }
  // The tips of the cone, and only there.
  EXPECT_GT(both.count(kPink, 0.5, 1), 15);
  EXPECT_EQ(both.count(kPink, 0, 0.5), 0);
  const Picture hexagon = draw({"--hexagon"});
  EXPECT_EQ(hexagon.count(kPink), 0);
  EXPECT_GT(hexagon.count(kGreen), both.count(kGreen, 0, 0.5));  // larger
  EXPECT_GT(draw({"--cone"}).count(kPink, 0.25, 0.75), 15);
}

TEST_F(PlotSpace, BarsGrowWhereTheFieldIs) {
  // Rotation about z with some stretch: linear, inner complex. A long bar between blue and red.
  const std::string field = (directory_ / "rotation.vtu").string();
  ASSERT_EQ(run({"generate", "constant", "-n", "2", "--tensor-value", "-1,-4,0,4,-1,0,0,0,2", "-o",
                 field})
                .code,
            0);
  const Picture empty = draw({"--hexagon"});
  const std::string numbers = (directory_ / "space.json").string();
  const Picture full = draw({field, "--hexagon", "--json", numbers});
  const HasHue between{275, 45, 0.4};  // the blend of blue and red
  EXPECT_GT(full.count(between, 0, 0.5), empty.count(between, 0, 0.5) + 10);
  const auto json = nlohmann::json::parse(file_content(numbers));
  EXPECT_NEAR(json["domains"]["inner-complex-linear"].get<double>(), 1, 1e-12);
  const auto share = json["share_by_row_edge_bin"].get<std::vector<double>>();
  EXPECT_EQ(share.size(), 41u * 6 * 30);
  EXPECT_NEAR(*std::max_element(share.begin(), share.end()), 1, 1e-12);
}

TEST_F(PlotSpace, SaysWhatIsWrong) {
  const std::string file = (directory_ / "space.png").string();
  const Outcome absent = run({"plot-space", "absent.vtu", "-o", file});
  EXPECT_EQ(absent.code, 1);
  EXPECT_THAT(absent.err, HasSubstr("absent.vtu"));
  const Outcome no_field = run({"plot-space", "-o", file, "--json", "a.json"});
  EXPECT_EQ(no_field.code, 1);
  EXPECT_THAT(no_field.err, HasSubstr("FIELD"));
}

}  // namespace
}  // namespace triplex::test
