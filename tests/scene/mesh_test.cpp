// mesh_test.cpp: generated meshes are closed, oriented and where they should be; OBJ files.
#include "scene/mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "tests/scene/scratch_scene.h"

namespace litmus {
namespace {

using testing::HasSubstr;

const Point& corner(const Mesh& mesh, std::size_t triangle, int k) {
  return mesh.vertices[std::size_t(mesh.triangles[triangle][std::size_t(k)])];
}

/// Every edge belongs to two triangles that run along it in opposite directions.
bool is_closed(const Mesh& mesh) {
  std::set<std::pair<int, int>> edges;
  for (const auto& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if (!edges.emplace(t[std::size_t(k)], t[std::size_t((k + 1) % 3)]).second) return false;
  for (const auto& [a, b] : edges)
    if (!edges.contains({b, a})) return false;
  return true;
}

/// Six times the volume inside; positive if the triangles are counter-clockwise from outside.
double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    sum += glm::dot(corner(mesh, i, 0), glm::cross(corner(mesh, i, 1), corner(mesh, i, 2)));
  return sum / 6;
}

TEST(IsClosed, IsFalseForAMeshWithAHole) {
  Mesh mesh = icosphere(Point(0), 1, 1, false);
  mesh.triangles.pop_back();
  EXPECT_FALSE(is_closed(mesh));
}

TEST(Icosphere, HasTwentyTimesFourToTheLevelTriangles) {
  EXPECT_EQ(icosphere(Point(0), 1, 0, false).triangles.size(), 20u);
  const Mesh mesh = icosphere(Point(0), 1, 6, true);
  EXPECT_EQ(mesh.triangles.size(), 81920u);
  EXPECT_EQ(mesh.vertices.size(), 40962u);  // Euler: faces / 2 + 2
  EXPECT_EQ(mesh.normals.size(), mesh.vertices.size());
}

TEST(Icosphere, IsClosedAndFacesOutwards) {
  const Mesh mesh = icosphere(Point(0), 2, 3, false);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume(mesh), 4.0 / 3 * M_PI * 8, 0.5);
  EXPECT_TRUE(mesh.normals.empty());
}

TEST(Icosphere, LiesOnTheSphereWithTheSpheresNormals) {
  const Point center(3, -2, 1);
  const Mesh mesh = icosphere(center, 0.5, 4, true);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    EXPECT_NEAR(glm::length(mesh.vertices[i] - center), 0.5, 1e-15 * 4);  // rounding of the sum
    EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 4e-16);
    EXPECT_NEAR(glm::length((mesh.vertices[i] - center) / 0.5 - mesh.normals[i]), 0, 4e-15);
  }
}

TEST(Torus, IsClosedAndFacesOutwards) {
  const Mesh mesh = torus(Point(0), Vector(1, 2, 3), 2, 0.5, 64, 32, false);
  EXPECT_EQ(mesh.triangles.size(), 2u * 64 * 32);
  EXPECT_TRUE(is_closed(mesh));
  EXPECT_NEAR(volume(mesh), 2 * M_PI * M_PI * 2 * 0.25, 0.1);
}

TEST(Torus, LiesOnTheTorusWithTheTorussNormals) {
  const Vector axis = glm::normalize(Vector(0.3, -1, 0.2));
  const Mesh mesh = torus(Point(0), axis, 2, 0.5, 16, 8, true);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Point& p = mesh.vertices[i];
    const Vector flat = p - glm::dot(p, axis) * axis, ring = glm::normalize(flat) * 2.0;
    EXPECT_NEAR(glm::length(p - ring), 0.5, 1e-14);
    EXPECT_NEAR(glm::length((p - ring) / 0.5 - mesh.normals[i]), 0, 1e-14);
  }
}

TEST(Torus, TakesAnyAxis) {
  for (const Vector axis : {Vector(1, 0, 0), Vector(0, -2, 0), Vector(0, 0, 1), Vector(1, 1, 1)})
    EXPECT_GT(volume(torus(Point(0), axis, 2, 0.5, 16, 8, false)), 0);
}

TEST(Grid, CoversTheParallelogramFacingUCrossV) {
  const Mesh mesh = grid(Point(1, 0, 0), Vector(2, 0, 0), Vector(0, 3, 0), 4, 5, true);
  EXPECT_EQ(mesh.triangles.size(), 40u);
  EXPECT_EQ(mesh.vertices.size(), 30u);
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    area +=
        glm::cross(corner(mesh, i, 1) - corner(mesh, i, 0), corner(mesh, i, 2) - corner(mesh, i, 0))
            .z /
        2;
  EXPECT_NEAR(area, 6, 1e-14);
  EXPECT_EQ(mesh.vertices.back(), Point(3, 3, 0));
  EXPECT_EQ(mesh.normals.front(), Vector(0, 0, 1));
}

TEST(SmoothNormals, AreWeightedByArea) {
  // At vertex 0 a triangle of area 2 facing z meets one of area 1/2 facing x.
  Mesh mesh{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 1, 0}, {0, 0, 1}}, {}, {{0, 1, 2}, {0, 3, 4}}};
  smooth_normals(mesh);
  EXPECT_NEAR(glm::length(mesh.normals[0] - glm::normalize(Vector(1, 0, 4))), 0, 1e-15);
  EXPECT_EQ(mesh.normals[1], Vector(0, 0, 1));
}

TEST(DropDegenerate, DropsExactlyTheTrianglesWithoutArea) {
  Mesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1e-150, 0}, {0, 1e300, 0}, {1e300, 0, 0}},
            {},
            {{0, 1, 2}, {0, 1, 1}, {0, 1, 3}, {0, 4, 5}}};
  EXPECT_EQ(drop_degenerate(mesh), 3);  // collinear, doubled, and a cross product that overflows
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(mesh.triangles[0][2], 3);
}

// ---- OBJ files -------------------------------------------------------------------------------

constexpr char kQuad[] = "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n";

Mesh read_text(const std::string& text, bool smooth = false, std::size_t most = 1000) {
  const ScratchFolder folder;
  return read_obj(folder.write("x.obj", text), smooth, most);
}

/// What read_obj says, or nothing.
std::string obj_complaint(const std::string& text, bool smooth = false, std::size_t most = 1000) {
  try {
    read_text(text, smooth, most);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(ReadObj, CutsPolygonsIntoTriangles) {
  const Mesh mesh = read_text(kQuad);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_TRUE(mesh.normals.empty());
  const Mesh hexagon =
      read_text("v 2 0 0\nv 1 2 0\nv -1 2 0\nv -2 0 0\nv -1 -2 0\nv 1 -2 0\nf 1 2 3 4 5 6\n");
  EXPECT_EQ(hexagon.triangles.size(), 4u);
}

TEST(ReadObj, KeepsTheAreaOfAConcavePolygon) {
  const Mesh mesh = read_text("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 0.5 0\nv 0 2 0\nf 1 2 3 4 5\n");
  double area = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    area +=
        glm::cross(corner(mesh, i, 1) - corner(mesh, i, 0), corner(mesh, i, 2) - corner(mesh, i, 0))
            .z /
        2;
  EXPECT_NEAR(area, 2.5, 1e-15);
}

TEST(ReadObj, RefusesAFaceWithoutEndQuickly) {
  const auto face = [](int corners) {
    std::string text = "f";
    for (int i = 0; i < corners; ++i) text += i % 2 ? " 2" : i % 4 ? " 3" : " 1";
    return kQuad + text + "\n";
  };
  EXPECT_EQ(obj_complaint(face(4), false, 100000), "");
  EXPECT_THAT(obj_complaint(face(4097), false, 100000),
              HasSubstr(":6: a face may have 4096 corners"));
}

TEST(ReadObj, KeepsEveryBitOfAVertex) {
  const Mesh mesh = read_text("v 0.1 1e-25 3.141592653589793\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(mesh.vertices[0], Point(0.1, 1e-25, 3.141592653589793));
}

TEST(ReadObj, UnderstandsTheFormatsOddities) {
  const Mesh mesh = read_text(
      "# comment\r\nmtllib none.mtl\r\no thing\r\nv +1 0 0 1.0\r\nv\t0 1 0\r\nv 0 0 1\r\n"
      "vt 0 0\r\ns off\r\nf -3/1 -2/1 -1/1\r\n");
  ASSERT_EQ(mesh.triangles.size(), 1u);
  EXPECT_EQ(corner(mesh, 0, 0), Point(1, 0, 0));
}

TEST(ReadObj, UsesTheFilesNormalsWhereItIsSmooth) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nvn 0 0 2\nvn 3 0 0\nf 1//1 2//1 3//1\nf 2//2 4//2 "
      "3//2\n";
  const Mesh mesh = read_text(text, true);
  EXPECT_EQ(mesh.vertices.size(), 6u);  // the shared edge keeps both its normals
  EXPECT_EQ(mesh.normals[0], Vector(0, 0, 1));
  EXPECT_EQ(mesh.normals[std::size_t(mesh.triangles[1][0])], Vector(1, 0, 0));
}

TEST(ReadObj, MakesNormalsWhereTheFileHasNone) {
  const Mesh mesh = read_text(kQuad, true);
  ASSERT_EQ(mesh.normals.size(), 4u);
  for (const Vector& normal : mesh.normals) EXPECT_GT(normal.z, 0.9);
}

TEST(ReadObj, RefusesVerticesThatAreNotNumbers) {
  EXPECT_EQ(obj_complaint(kQuad), "");
  EXPECT_THAT(obj_complaint("v 0 0 0\nv nan 0 0\n"),
              HasSubstr(":2: a vertex must be three finite"));
  EXPECT_THAT(obj_complaint("v 0 0 0\nv 1 inf 0\n"), HasSubstr(":2: "));
  EXPECT_THAT(obj_complaint("v 0 0\n"), HasSubstr(":1: "));
  EXPECT_THAT(obj_complaint("v 0 0 1e999\n"), HasSubstr(":1: "));
}

TEST(ReadObj, RefusesIndicesThatNameNothing) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(obj_complaint(vertices + "f 1 2 3\n"), "");
  EXPECT_THAT(obj_complaint(vertices + "f 1 2 4\n"),
              HasSubstr(":4: \"4\" names no vertex; there are 3"));
  EXPECT_THAT(obj_complaint(vertices + "f 0 1 2\n"), HasSubstr(":4: "));
  EXPECT_THAT(obj_complaint(vertices + "f -4 1 2\n"), HasSubstr(":4: "));
  EXPECT_THAT(obj_complaint(vertices + "f 1 2 x\n"), HasSubstr(":4: "));
  EXPECT_THAT(obj_complaint(vertices + "f 1 2 99999999999999999999\n"), HasSubstr(":4: "));
  EXPECT_THAT(obj_complaint(vertices + "f 1//1 2//1 3//1\n"), HasSubstr("names no normal"));
  EXPECT_THAT(obj_complaint(vertices + "f 1 2\n"), HasSubstr("at least 3 corners"));
}

TEST(ReadObj, RefusesAFileWithoutFaces) {
  EXPECT_THAT(obj_complaint(""), HasSubstr("no faces"));
  EXPECT_THAT(obj_complaint("v 0 0 0\n"), HasSubstr("no faces"));
}

TEST(ReadObj, RefusesMoreTrianglesThanThereIsRoomFor) {
  EXPECT_EQ(obj_complaint(kQuad, false, 2), "");
  EXPECT_THAT(obj_complaint(kQuad, false, 1), HasSubstr(":5: more than 1 triangles"));
}

TEST(ReadObj, IsPlacedByTheScene) {
  const ScratchFolder folder;
  folder.write("quad.obj", kQuad);
  const auto file = folder.write(
      "scene.toml",
      replaced(kScratchScene,
               "generator = \"icosphere\"\ncenter = [3, 0, 1]\nradius = 0.25\nlevel = 1",
               "file = \"quad.obj\"\nscale = 2\ntranslate = [0, 0, 5]"));
  const Scene scene = load_scene(file);
  EXPECT_EQ(std::get<Mesh>(scene.objects[4].shape).vertices[2], Point(2, 2, 5.2));
}

TEST(ReadObj, PassesItsComplaintOnWithThePlaceInTheScene) {
  const ScratchFolder folder;
  folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  std::string text = replaced(
      kScratchScene, "generator = \"icosphere\"\ncenter = [3, 0, 1]\nradius = 0.25\nlevel = 1",
      "file = @\"bad.obj\"");
  const std::string place = take_mark(text);
  EXPECT_THAT(refusal_of(folder.write("scene.toml", text)),
              HasSubstr("scene.toml:" + place + ": file: bad.obj:2: \"2\" names no vertex"));
}

}  // namespace
}  // namespace litmus
