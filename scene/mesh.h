// mesh.h: triangle meshes made by formula or read from a Wavefront OBJ file.
#pragma once

#include <cstdint>
#include <filesystem>

#include "scene/scene.h"

namespace litmus {

/// A sphere of 20 * 4^level triangles: an icosahedron whose edges are halved and pushed onto the
/// sphere `level` times. Vertices are shared, triangles counter-clockwise from outside. Smooth
/// normals are the sphere's own, (vertex - center) / radius. radius > 0, level 0..7.
Mesh icosphere(Point center, double radius, int level, bool smooth);

/// 2 * segments * sides triangles around `axis` (any length): `segments` along the ring of radius
/// `major`, `sides` around the tube of radius `minor` < major; both >= 3. Smooth normals are the
/// torus's own.
Mesh torus(Point center, Vector axis, double major, double minor, int segments, int sides,
           bool smooth);

/// A flat parallelogram origin + s u + t v, s and t in 0..1, of 2 * columns * rows triangles that
/// face u x v. u and v are not parallel.
Mesh grid(Point origin, Vector u, Vector v, int columns, int rows, bool smooth);

/// An OBJ file's faces as triangles. smooth: the file's own normals, normalised, where every corner
/// has one, else smooth_normals. Materials, groups and texture coordinates are ignored. Throws
/// std::runtime_error whose text follows the file's name (": no such file", ":7: ...") if the file
/// cannot be read, is larger than kLargestFile, holds no face or more than `most_triangles`, or has
/// a vertex that is not three finite numbers or an index that names nothing.
Mesh read_obj(const std::filesystem::path& file, bool smooth, std::size_t most_triangles);

/// One unit normal per vertex: the sum of its triangles' normals weighted by their areas. (0,0,1)
/// for a vertex where that sum vanishes.
void smooth_normals(Mesh& mesh);

/// Removes the triangles whose edges' cross product is exactly zero or not finite; returns how
/// many.
std::int64_t drop_degenerate(Mesh& mesh);

/// True for the triangles that drop_degenerate removes.
bool degenerate(const Point& a, const Point& b, const Point& c);

}  // namespace litmus
