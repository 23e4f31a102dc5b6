// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// `triplex render`, under a virtual X server.
#include <gmock/gmock.h>

#include "picture.hpp"
#include "virtual_display.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const Picture::Rgb kWhite = {255, 255, 255};

// One extraction for all tests of the file.
class Render : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    directory_ = new TemporaryDirectory;
    const Outcome extracted =
        run({"extract", make_field(*directory_, "lorenz", 6), "-o", meshes()});
    ASSERT_TRUE(extracted.code == 0 || extracted.code == 2) << extracted.err;
  }
  static void TearDownTestSuite() { delete directory_; }
  void SetUp() override {
    if (!has_virtual_display()) GTEST_SKIP() << "needs xvfb-run (packages xvfb and xauth)";
  }
  static std::string meshes() { return (*directory_ / "out").string(); }
  static std::string path(const std::string& name) { return (*directory_ / name).string(); }

  /// A picture of 320 x 240 pixels.
  static Picture draw(std::vector<std::string> options) {
    const std::string file = path("picture.png");
    options.insert(options.begin(), {"render", meshes(), "-o", file, "--size", "320x240"});
    const Outcome outcome = run_on_virtual_display(options);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return Picture(file);
  }
  static Outcome refused(std::vector<std::string> options) {
    const std::string file = path("refused.png");
    options.insert(options.begin(), {"render", meshes(), "-o", file});
    Outcome outcome = run(options);
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    EXPECT_FALSE(fs::exists(file));
    return outcome;
  }

 private:
  static inline TemporaryDirectory* directory_ = nullptr;
};

TEST_F(Render, DrawsWhatExtractWrote) {
  const Picture picture = draw({});
  EXPECT_EQ(picture.width(), 320);
  EXPECT_EQ(picture.height(), 240);
  EXPECT_GT(picture.different_colors(), 100u);  // shaded surfaces, not a blank page
  for (const HasHue& hue : {kGreen, kYellow, kOrange, kRed, kBlue, kMagenta})
    EXPECT_GT(picture.count(hue), 50) << hue.hue;
  const Outcome below_file =
      run_on_virtual_display({"render", meshes(), "-o", path("picture.png/a.png")});
  EXPECT_EQ(below_file.code, 4) << below_file.err;
}

TEST_F(Render, FeaturesAndLegendAreThoseAskedFor) {
  const Picture degenerate = draw({"--features", "degenerate-linear,degenerate-planar"});
  for (const HasHue& hue : {kGreen, kYellow}) EXPECT_GT(degenerate.count(hue), 500) << hue.hue;
  for (const HasHue& hue : {kOrange, kRed, kBlue, kMagenta})
    EXPECT_EQ(degenerate.count(hue), 0) << hue.hue;
  const Picture none = draw({"--features", "none", "--outline", "none"});
  EXPECT_EQ(none.count_color(kWhite), 320 * 240);
  const Picture no_legend =
      draw({"--features", "triple-curve", "--outline", "none", "--no-legend"});
  const Picture legend = draw({"--features", "triple-curve", "--outline", "none"});
  EXPECT_LT(no_legend.count([](const Picture::Rgb& c) { return c[0] < 60; }),
            legend.count([](const Picture::Rgb& c) { return c[0] < 60; }));
  EXPECT_GT(no_legend.count([](const Picture::Rgb& c) { return c[0] < 60; }), 50);  // the curve
}

TEST_F(Render, NodesAreSpheres) {
  const HasHue cyan{189};
  const std::vector<std::string> degenerate = {"--no-legend", "--features", "degenerate-planar",
                                               "--opacity", "0.3"};
  std::vector<std::string> without = degenerate;
  without.emplace_back("--no-nodes");
  EXPECT_GT(draw(degenerate).count(cyan), 4);
  EXPECT_EQ(draw(without).count(cyan), 0);
}

TEST_F(Render, TransparentSurfacesShowWhatIsBehind) {
  const auto saturated = [](const Picture::Rgb& c) { return HasHue{28, 9, 0.7}(c); };
  const Picture opaque = draw({"--features", "neutral-real", "--no-legend"});
  const Picture faint = draw({"--features", "neutral-real", "--no-legend", "--opacity", "0.3"});
  EXPECT_GT(opaque.count(saturated), 1000);
  EXPECT_LT(faint.count(saturated), opaque.count(saturated) / 4);
  // One feature alone: the other one keeps its colour.
  const Picture one = draw({"--features", "neutral-real,degenerate-linear", "--no-legend",
                            "--opacity", "neutral-real=0.1"});
  EXPECT_LT(one.count(saturated), opaque.count(saturated) / 4);
  EXPECT_GT(one.count(HasHue{131, 9, 0.7}), 1000);
}

TEST_F(Render, ClipRemovesWhatLiesOutside) {
  const Picture whole = draw({"--features", "degenerate-linear,degenerate-planar", "--no-legend"});
  // A corner of the box that no degenerate surface reaches.
  const Picture part = draw({"--features", "degenerate-linear,degenerate-planar", "--no-legend",
                             "--clip", "-30,-29,-30,-29,0,1"});
  EXPECT_GT(whole.count(kYellow), 500);
  EXPECT_EQ(part.count(kYellow) + part.count(kGreen), 0);
  const Picture closer = draw(
      {"--features", "triple-curve", "--no-legend", "--clip", "1,9,-30,30,0,60", "--camera", "y"});
  EXPECT_GT(closer.count([](const Picture::Rgb& c) { return c[0] < 60; }), 20);
}

TEST_F(Render, ViewsAndSheetsGivePanels) {
  const Picture views = draw({"--views", "x,-x", "--features", "balanced-linear", "--no-legend"});
  // Seen from both sides of the x axis the cylinder y -> -y is its own mirror image: both panels
  // have as much blue.
  const int left = views.count(kBlue, 0, 0.5), right = views.count(kBlue, 0.5, 1);
  EXPECT_GT(left, 500);
  EXPECT_NEAR(left, right, 0.05 * left);
  const Picture sheet = draw({"--sheet", "--columns", "4", "--no-legend"});
  EXPECT_GT(sheet.count(kGreen, 0.25, 0.5), 100);
  EXPECT_EQ(sheet.count(kBlue, 0.25, 0.5) + sheet.count(kRed, 0.25, 0.5), 0);
  EXPECT_GT(sheet.count(kRed, 0.5, 0.75), 100);
  EXPECT_EQ(sheet.count(kGreen, 0.5, 0.75), 0);
  EXPECT_GT(sheet.count(kMagenta, 0.75, 1), 100);
  EXPECT_EQ(sheet.count(kOrange, 0.75, 1), 0);
}

TEST_F(Render, PanelsHoldTheFeaturesAndFilesAskedFor) {
  const std::string curve = meshes() + "/triple-curve.vtp:#00ffff";
  const Picture panels =
      draw({"--panel", "neutral-real,triple-curve", "--panel", "degenerate-linear", "--columns",
            "2", "--no-legend", "--with", "2@" + curve});
  EXPECT_GT(panels.count(kOrange, 0, 0.5), 500);
  EXPECT_EQ(panels.count(kGreen, 0, 0.5) + panels.count(kOrange, 0.5, 1), 0);
  EXPECT_GT(panels.count(kGreen, 0.5, 1), 500);
  const HasHue cyan{180, 5, 0.8};
  EXPECT_GT(panels.count(cyan, 0.5, 1), 3);
  EXPECT_EQ(panels.count(cyan, 0, 0.5), 0);
}

TEST_F(Render, SeveralDirectoriesGivePanels) {
  const std::string out = path("balanced");
  ASSERT_EQ(run({"extract", path("lorenz.vtu"), "-o", out, "--features", "balanced-linear"}).code,
            0);
  const Picture both = draw({out, "--columns", "2", "--no-legend"});
  EXPECT_GT(both.count(kGreen, 0, 0.5), 100);
  EXPECT_EQ(both.count(kGreen, 0.5, 1), 0);
  EXPECT_GT(both.count(kBlue, 0.5, 1), 500);
}

TEST_F(Render, ViewZoomBackgroundSilhouettesCaption) {
  const std::vector<std::string> plain = {"--features", "balanced-linear", "--no-legend",
                                          "--outline", "none"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = plain;
    all.insert(all.end(), more.begin(), more.end());
    return draw(all);
  };
  const int blue = with({}).count(kBlue);
  EXPECT_LT(with({"--zoom", "0.5"}).count(kBlue), blue / 3);
  EXPECT_EQ(with({"--camera", "x"}).count(kBlue), with({"--view", "0,0"}).count(kBlue));
  EXPECT_NE(with({"--view", "20,50"}).count(kBlue), blue);
  EXPECT_GT(with({"--background", "#102030"}).count_color({16, 32, 48}), 1000);
  const auto dark = [](const Picture::Rgb& c) { return c[0] + c[1] + c[2] < 200; };
  EXPECT_GT(with({"--silhouettes"}).count(dark), with({}).count(dark) + 50);
  EXPECT_GT(with({"--caption", "WWWWWWWWWWWWWWWWWW"}).count(dark), with({}).count(dark) + 20);
  const HasHue gold{51, 5};
  EXPECT_GT(draw({"--features", "balanced-linear", "--no-legend", "--outline", "gold"}).count(gold),
            100);
}

TEST_F(Render, DrawsOtherFilesInTheirColours) {
  write_content(path("red_square.vtp"),
                R"(<?xml version="1.0"?><VTKFile type="PolyData" version="1.0"><PolyData>
<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="1">
<PointData><DataArray type="Float64" Name="displacement" NumberOfComponents="3" format="ascii">
0 0 1000 0 0 1000 0 0 1000 0 0 1000</DataArray></PointData>
<CellData><DataArray type="UInt8" Name="RGB" NumberOfComponents="3" format="ascii">0 220 220
</DataArray></CellData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
-20 0 10  20 0 10  20 0 50  -20 0 50</DataArray></Points>
<Polys><DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4</DataArray></Polys></Piece></PolyData></VTKFile>)");
  const std::string square = path("red_square.vtp");
  const std::vector<std::string> plain = {"--features", "none",     "--outline",
                                          "none",       "--camera", "-y"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = plain;
    all.insert(all.end(), more.begin(), more.end());
    return draw(all);
  };
  const HasHue cyan{180};
  EXPECT_GT(with({"--with", square}).count(cyan), 3000);
  EXPECT_EQ(with({"--with", square + ":magenta"}).count(cyan), 0);
  EXPECT_GT(with({"--with", square + ":magenta"}).count(HasHue{300}), 3000);
  EXPECT_EQ(with({"--with", square + ":magenta:0.2"}).count(HasHue{300}), 0);
  // Far above, the domain and the square together are a tall box: the square is small.
  EXPECT_LT(with({"--with", square, "--displace", "displacement"}).count(cyan), 1000);
  // The boundary of a mesh hides what is inside.
  EXPECT_GT(with({"--with", path("lorenz.vtu") + ":#00ff00"}).count(HasHue{120}), 20000);
  // Spheres and tubes: the curve in gold.
  EXPECT_GT(with({"--with", meshes() + "/triple-curve.vtp:gold"}).count(HasHue{51}), 50);
}

TEST_F(Render, SaysWhatIsWrongWithAnOption) {
  EXPECT_THAT(refused({"--size", "10x10"}).err, HasSubstr("--size"));
  EXPECT_THAT(refused({"--camera", "w"}).err, HasSubstr("'w'"));
  EXPECT_THAT(refused({"--view", "30"}).err, HasSubstr("2 numbers"));
  EXPECT_THAT(refused({"--clip", "0,1,2"}).err, HasSubstr("6 numbers"));
  EXPECT_THAT(refused({"--clip", "1,0,0,1,0,1"}).err, HasSubstr("XMIN"));
  EXPECT_THAT(refused({"--opacity", "2"}).err, HasSubstr("between 0 and 1"));
  EXPECT_THAT(refused({"--opacity", "front=1"}).err, HasSubstr("'front'"));
  EXPECT_THAT(refused({"--panel", "neutral-real,front"}).err, HasSubstr("'front'"));
  EXPECT_THAT(refused({"--background", "nocolour"}).err, HasSubstr("'nocolour'"));
  EXPECT_THAT(refused({"--with", path("absent.vtp")}).err, HasSubstr("absent.vtp"));
  EXPECT_THAT(refused({"--with", meshes() + "/report.json"}).err, HasSubstr("report.json"));
  EXPECT_THAT(refused({"--caption", "a", "--caption", "b"}).err, HasSubstr("2 captions"));
}

TEST_F(Render, RefusesADirectoryWithoutMeshes) {
  const TemporaryDirectory directory;
  const Outcome outcome =
      run({"render", (directory / "absent").string(), "-o", (directory / "a.png").string()});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("absent"));
}

TEST_F(Render, WithoutADisplayNamesTheCure) {
  const TemporaryDirectory directory;
  Process::Options bare;
  bare.executable = "env";
  const Outcome outcome = Process({"-u", "DISPLAY", TRIPLEX_PROGRAM, "render", meshes(), "-o",
                                   (directory / "a.png").string()},
                                  bare)
                              .wait();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("xvfb-run"));
  EXPECT_FALSE(fs::exists(directory / "a.png"));
}

}  // namespace
}  // namespace triplex::test
