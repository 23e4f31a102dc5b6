// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files that consist of pieces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "reading.hpp"

namespace triplex {
namespace {

using test::message_of;
using test::read_text;
using test::same_bits;
using test::TemporaryDirectory;
using test::VtuText;
using test::write_content;
using testing::AllOf;
using testing::HasSubstr;

/// The mesh of `VtuText` as two files with one tet each, and the .pvtu file that joins them.
class Pieces : public testing::Test {
 protected:
  Pieces() {
    const VtuText whole;
    const auto& tensors = whole.point_data[0].values;
    first_.points.resize(12);
    first_.point_data[0].values.resize(36);
    first_.connectivity = {0, 1, 2, 3};
    second_.points = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0};
    second_.connectivity = {2, 3, 0, 1};
    second_.point_data[0].values.clear();
    for (const int old : {1, 4, 0, 2}) {
      second_.point_data[0].values.insert(second_.point_data[0].values.end(),
                                          tensors.begin() + 9 * old, tensors.begin() + 9 * old + 9);
    }
    for (VtuText* piece : {&first_, &second_}) {
      piece->offsets = {4};
      piece->types = {10};
    }
  }

  std::filesystem::path write(bool ghosts = false) {
    write_content(directory_ / "p0.vtu", first_.text());
    write_content(directory_ / "p1.vtu", second_.text());
    write_content(directory_ / "all.pvtu", test::pvtu_text({"p0.vtu", "p1.vtu"}, ghosts));
    return directory_ / "all.pvtu";
  }

  /// Adds to the second piece a copy of the first piece's cell and point, flagged as such.
  void add_ghosts(double tensor_shift) {
    second_.points.insert(second_.points.end(), {0, 0, 1});
    second_.connectivity.insert(second_.connectivity.end(), {2, 0, 3, 4});
    second_.offsets.push_back(8);
    second_.types.push_back(10);
    auto& values = second_.point_data[0].values;
    for (int i = 27; i < 36; ++i) values.push_back(first_.point_data[0].values[i] + tensor_shift);
    // Points 0, 2, 3 belong to the first piece as well; wrong tensors there must not matter.
    for (const int point : {0, 2, 3}) values[9 * point] += tensor_shift;
    first_.cell_data = {{"vtkGhostType", 1, {0}, "UInt8"}};
    first_.point_data.push_back({"vtkGhostType", 1, {0, 0, 0, 0}, "UInt8"});
    second_.cell_data = {{"vtkGhostType", 1, {0, 1}, "UInt8"}};
    second_.point_data.push_back({"vtkGhostType", 1, {1, 0, 1, 1, 1}, "UInt8"});
  }

  TemporaryDirectory directory_;
  VtuText first_, second_;
};

TEST_F(Pieces, AreJoined) {
  const TensorField field = read_field(write());
  EXPECT_TRUE(same_bits(field, read_text({})));
  EXPECT_TRUE(field.source_cells.empty());
}

TEST_F(Pieces, GhostsAreLeftOut) {
  for (const double shift : {0.0, 1.0}) {
    SCOPED_TRACE(shift);
    Pieces::SetUp();
    const VtuText first = first_, second = second_;
    add_ghosts(shift);
    const TensorField field = read_field(write(true));
    EXPECT_TRUE(same_bits(field, read_text({})));
    EXPECT_EQ(field.source_cells, (std::vector<std::int64_t>{0, 1}));
    first_ = first;
    second_ = second;
  }
}

TEST_F(Pieces, RepeatedCellsAreLeftOut) {
  add_ghosts(0);
  for (VtuText* piece : {&first_, &second_}) {  // the same without flags
    piece->cell_data.clear();
    piece->point_data.pop_back();
  }
  // The copy comes first now: cells 0 (first piece), 1 (its copy), 2.
  std::rotate(second_.connectivity.begin(), second_.connectivity.begin() + 4,
              second_.connectivity.end());
  const TensorField field = read_field(write());
  EXPECT_TRUE(same_bits(field, read_text({})));
  EXPECT_EQ(field.source_cells, (std::vector<std::int64_t>{0, 2}));
}

TEST_F(Pieces, MustAgree) {
  second_.point_data[0].values[9 * 2 + 4] += 1;
  EXPECT_THAT(message_of(write()), AllOf(HasSubstr("the pieces disagree"),
                                         HasSubstr("points 0 and 6"), HasSubstr("(0, 0, 0)")));
}

TEST_F(Pieces, MustExist) {
  const auto file = write();
  std::filesystem::remove(directory_ / "p1.vtu");
  EXPECT_NE(message_of(file), "accepted");
  write_content(directory_ / "p1.vtu", first_.text().substr(0, 900));
  EXPECT_NE(message_of(file), "accepted");
}

}  // namespace
}  // namespace triplex
