// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pictures of docs/gallery.md: there, not blank, and with the colours that gallery.tsv expects.
#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <sstream>

#include "../io/temporary_directory.hpp"
#include "picture.hpp"

namespace triplex::test {
namespace {

namespace fs = std::filesystem;

const fs::path kDocs = TRIPLEX_DOCS_DIR;
constexpr std::uintmax_t kLargest = 400'000, kLargestSum = 4'500'000;  // bytes

const std::map<std::string, HasHue>& hues() {
  static const std::map<std::string, HasHue> table = {
      {"green", kGreen},    {"yellow", kYellow},   {"orange", kOrange},     {"red", kRed},
      {"blue", kBlue},      {"magenta", kMagenta}, {"cyan", {189}},         {"navy", {235, 9}},
      {"teal", {180}},      {"brown", {27, 6}},    {"pink", {342, 8, 0.2}}, {"gold", {51, 5}},
      {"steelblue", {207}}, {"tan", {34, 6, 0.2}}, {"leaf", {112, 14}},     {"goldenrod", {43, 4}}};
  return table;
}

struct Row {
  std::string picture;
  std::map<std::string, int> least;  // pixels, by colour
};

// A line for each picture: its name and, for each colour expected, NAME=PIXELS.
std::vector<Row> rows() {
  std::vector<Row> result;
  std::ifstream file(TRIPLEX_GALLERY_TABLE);
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    Row row;
    words >> row.picture;
    for (std::string word; words >> word;) {
      const auto equals = word.find('=');
      row.least[word.substr(0, equals)] = std::stoi(word.substr(equals + 1));
    }
    result.push_back(row);
  }
  return result;
}

TEST(Gallery, PicturesHoldTheColoursExpected) {
  const std::vector<Row> table = rows();
  ASSERT_FALSE(table.empty());
  for (const Row& row : table) {
    SCOPED_TRACE(row.picture);
    const Picture picture(kDocs / "gallery" / (row.picture + ".png"));
    ASSERT_GT(picture.width(), 500);
    EXPECT_GT(picture.different_colors(), 500u);
    const int white = picture.count_color({255, 255, 255});
    EXPECT_GT(white, picture.width() * picture.height() / 5);
    EXPECT_LT(white, picture.width() * picture.height() * 97 / 100);
    EXPECT_FALSE(row.least.empty());
    for (const auto& [color, pixels] : row.least)
      EXPECT_GE(picture.count(hues().at(color)), pixels) << color;
  }
}

TEST(Gallery, TablePageAndFilesNameTheSamePictures) {
  const std::string page = file_content(kDocs / "gallery.md");
  std::set<std::string> listed;
  for (const Row& row : rows()) {
    listed.insert(row.picture);
    EXPECT_THAT(page, testing::HasSubstr("(gallery/" + row.picture + ".png)"));
  }
  std::uintmax_t sum = 0;
  for (const auto& entry : fs::directory_iterator(kDocs / "gallery")) {
    if (entry.path().extension() != ".png") continue;
    EXPECT_TRUE(listed.count(entry.path().stem().string()) > 0) << entry.path();
    EXPECT_LE(entry.file_size(), kLargest) << entry.path();
    sum += entry.file_size();
  }
  EXPECT_LE(sum, kLargestSum);
}

}  // namespace
}  // namespace triplex::test
