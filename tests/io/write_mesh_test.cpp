// SPDX-FileCopyrightText: The Triplex authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "triplex/io/write_mesh.hpp"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPartitionedDataSetCollectionReader.h>
#include <vtkXMLPolyDataReader.h>

#include <cmath>
#include <cstring>
#include <sstream>

#include "read_vtk.hpp"
#include "sample_mesh.hpp"
#include "temporary_directory.hpp"

namespace triplex {
namespace {

using test::file_content;
using test::surface;
using test::TemporaryDirectory;

FeatureMesh curve() {
  FeatureMesh mesh = surface();
  mesh.triangles.clear();
  mesh.segments = {{0, 1}, {1, 3}};
  return mesh;
}
std::vector<PointValues> extra() { return {{"eigen-values", 2, {1, 2, 3, 4, 5, 6, 7, 8}}}; }

TEST(MeshFormats, HaveNames) {
  for (const char* name : {"vtp", "ply", "obj", "stl"}) {
    const auto format = mesh_format_named(name);
    ASSERT_TRUE(format.has_value());
    EXPECT_EQ(name_of(*format), name);
  }
  EXPECT_FALSE(mesh_format_named("vtk").has_value());
  EXPECT_FALSE(mesh_format_named("").has_value());
}

/// A reader of its own for binary PLY files whose vertices are doubles: VTK's drops to floats.
struct Ply {
  std::vector<std::string> vertex_properties;
  std::vector<double> values;
  std::vector<std::array<std::int32_t, 3>> faces;
  std::vector<std::array<std::int32_t, 2>> edges;
  std::vector<int> certified;
  std::size_t unread = 0;

  explicit Ply(const std::string& bytes) {
    const std::size_t end = bytes.find("end_header\n");
    std::istringstream header(bytes.substr(0, end));
    std::string line, element;
    std::size_t vertices = 0, face_count = 0, edge_count = 0;
    EXPECT_TRUE(bytes.starts_with("ply\nformat binary_little_endian 1.0\n"));
    while (std::getline(header, line)) {
      std::istringstream words(line);
      std::string word, type, name;
      words >> word;
      if (word == "element") {
        std::size_t count = 0;
        words >> element >> count;
        (element == "vertex" ? vertices : element == "face" ? face_count : edge_count) = count;
      } else if (word == "property" && element == "vertex") {
        words >> type >> name;
        EXPECT_EQ(type, "double");
        vertex_properties.push_back(name);
      }
    }
    at_ = bytes.data() + end + std::strlen("end_header\n");
    values.resize(vertices * vertex_properties.size());
    for (double& x : values) x = take<double>();
    for (std::size_t n = 0; n < face_count; ++n) {
      EXPECT_EQ(take<std::uint8_t>(), 3);
      faces.push_back(take<std::array<std::int32_t, 3>>());
      certified.push_back(take<std::uint8_t>());
    }
    for (std::size_t n = 0; n < edge_count; ++n) {
      edges.push_back(take<std::array<std::int32_t, 2>>());
      certified.push_back(take<std::uint8_t>());
    }
    unread = static_cast<std::size_t>(bytes.data() + bytes.size() - at_);
  }

 private:
  template <class T>
  T take() {
    T value;
    std::memcpy(&value, at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  const char* at_;
};

TEST(Ply, KeepsEveryDoubleAndEveryArray) {
  const TemporaryDirectory directory;
  const FeatureMesh mesh = surface();
  write_mesh(directory / "a.ply", MeshFormat::Ply, mesh, Feature::NeutralReal, extra());
  const Ply ply(file_content(directory / "a.ply"));
  EXPECT_EQ(ply.vertex_properties, (std::vector<std::string>{"x", "y", "z", "p", "q", "mode",
                                                             "eigen_values_0", "eigen_values_1"}));
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const std::array<double, 8> expected = {mesh.points[v][0], mesh.points[v][1], mesh.points[v][2],
                                            mesh.p[v],         mesh.q[v],         mesh.mode[v],
                                            1 + 2.0 * v,       2 + 2.0 * v};
    EXPECT_EQ(std::memcmp(&ply.values[8 * v], expected.data(), sizeof(expected)), 0) << v;
  }
  EXPECT_EQ(ply.faces, (std::vector<std::array<std::int32_t, 3>>{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(ply.certified, (std::vector<int>{1, 0}));
  EXPECT_EQ(ply.unread, 0u);
}

TEST(Ply, HoldsTheCurveAsEdges) {
  const TemporaryDirectory directory;
  write_mesh(directory / "a.ply", MeshFormat::Ply, curve(), Feature::TripleCurve);
  const Ply ply(file_content(directory / "a.ply"));
  EXPECT_TRUE(ply.faces.empty());
  EXPECT_EQ(ply.edges, (std::vector<std::array<std::int32_t, 2>>{{0, 1}, {1, 3}}));
  EXPECT_EQ(ply.certified, (std::vector<int>{1, 0}));
  EXPECT_EQ(ply.unread, 0u);
}

TEST(Obj, ReadsBackAsTheSameDoubles) {
  const TemporaryDirectory directory;
  for (const FeatureMesh& mesh : {surface(), curve()}) {
    write_mesh(directory / "a.obj", MeshFormat::Obj, mesh, Feature::TripleCurve);
    std::istringstream text(file_content(directory / "a.obj"));
    std::vector<Point> points;
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::vector<std::array<std::uint32_t, 2>> lines;
    std::string line;
    while (std::getline(text, line)) {
      std::istringstream words(line);
      std::string kind, a, b, c;
      words >> kind >> a >> b >> c;
      const auto id = [](const std::string& s) {
        return static_cast<std::uint32_t>(std::stoul(s)) - 1;
      };
      if (kind == "v")
        points.push_back({std::strtod(a.c_str(), nullptr), std::strtod(b.c_str(), nullptr),
                          std::strtod(c.c_str(), nullptr)});
      if (kind == "f") faces.push_back({id(a), id(b), id(c)});
      if (kind == "l") lines.push_back({id(a), id(b)});
    }
    ASSERT_EQ(points.size(), mesh.points.size());
    EXPECT_EQ(std::memcmp(points.data(), mesh.points.data(), points.size() * sizeof(Point)), 0);
    EXPECT_EQ(faces, mesh.triangles);
    EXPECT_EQ(lines, mesh.segments);
  }
}

TEST(Stl, HoldsTheTrianglesInSinglePrecision) {
  const TemporaryDirectory directory;
  FeatureMesh mesh = surface();
  mesh.points = {{0, 0, 0}, {1.0 / 3, 0, 0}, {0, 1, 0}, {0.1, 2, 1}};
  write_mesh(directory / "a.stl", MeshFormat::Stl, mesh, Feature::NeutralReal);
  const std::string bytes = file_content(directory / "a.stl");
  // 80 bytes of header, which must not begin with "solid", and a count; 12 floats and 2 bytes each.
  ASSERT_EQ(bytes.size(), 84 + 2 * 50u);
  EXPECT_FALSE(bytes.starts_with("solid"));
  std::uint32_t count = 0;
  std::memcpy(&count, &bytes[80], 4);
  EXPECT_EQ(count, 2u);
  for (std::size_t t = 0; t < 2; ++t) {
    std::array<float, 12> numbers{};
    std::memcpy(numbers.data(), &bytes[84 + 50 * t], sizeof(numbers));
    const float* const normal = numbers.data();
    EXPECT_NEAR(std::hypot(normal[0], normal[1], normal[2]), 1, 1e-6);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(numbers[3 + 3 * k + i], static_cast<float>(mesh.points[mesh.triangles[t][k]][i]));
  }
  float z_of_first = 0;
  std::memcpy(&z_of_first, &bytes[84 + 8], 4);
  EXPECT_EQ(z_of_first, 1.0F);  // counter-clockwise: up
  write_mesh(directory / "b.stl", MeshFormat::Stl, curve(), Feature::TripleCurve);
  EXPECT_EQ(file_content(directory / "b.stl").size(), 84u);
}

TEST(Vtp, CarriesFurtherArrays) {
  const TemporaryDirectory directory;
  write_mesh(directory / "a.vtp", MeshFormat::Vtp, surface(), Feature::NeutralReal, extra());
  const auto data = test::read_vtk<vtkXMLPolyDataReader>(directory / "a.vtp");
  auto* array = vtkDoubleArray::SafeDownCast(data->GetPointData()->GetArray("eigen-values"));
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetNumberOfComponents(), 2);
  EXPECT_EQ(array->GetValue(7), 8);
}

TEST(Collection, IsReadByVtkAsNamedBlocks) {
  const TemporaryDirectory directory;
  write_mesh(directory / "neutral-real.vtp", MeshFormat::Vtp, surface(), Feature::NeutralReal);
  write_mesh(directory / "triple-curve.vtp", MeshFormat::Vtp, curve(), Feature::TripleCurve);
  const std::array<std::string_view, 2> names = {"neutral-real", "triple-curve"};
  write_collection(directory / "features.vtpc", names);
  vtkNew<vtkXMLPartitionedDataSetCollectionReader> reader;
  reader->SetFileName((directory / "features.vtpc").c_str());
  reader->Update();
  auto* all = vtkPartitionedDataSetCollection::SafeDownCast(reader->GetOutputDataObject(0));
  ASSERT_NE(all, nullptr);
  ASSERT_EQ(all->GetNumberOfPartitionedDataSets(), 2u);
  for (unsigned k = 0; k < 2; ++k) {
    ASSERT_TRUE(all->HasMetaData(k));
    EXPECT_EQ(all->GetMetaData(k)->Get(vtkCompositeDataSet::NAME()), names[k]);
    auto* block = vtkPolyData::SafeDownCast(all->GetPartition(k, 0));
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(block->GetNumberOfPoints(), 4);
    EXPECT_EQ(k == 0 ? block->GetNumberOfPolys() : block->GetNumberOfLines(), 2);
    double x[3];
    block->GetPoint(3, x);
    EXPECT_EQ(std::memcmp(x, surface().points[3].data(), sizeof(x)), 0);
  }
}

TEST(Meshes, RefuseArraysThatDoNotFit) {
  const TemporaryDirectory directory;
  for (const MeshFormat format :
       {MeshFormat::Vtp, MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Stl}) {
    FeatureMesh mesh = surface();
    mesh.q.pop_back();
    EXPECT_THROW(write_mesh(directory / "a", format, mesh, Feature::NeutralReal),
                 std::invalid_argument);
    auto arrays = extra();
    arrays[0].components = 3;
    EXPECT_THROW(write_mesh(directory / "a", format, surface(), Feature::NeutralReal, arrays),
                 std::invalid_argument);
    EXPECT_THROW(write_mesh("/dev/full", format, surface(), Feature::NeutralReal), IoError);
  }
}

}  // namespace
}  // namespace triplex
