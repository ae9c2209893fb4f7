// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TangledBall.h"

#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

// Generators of extreme meshes for the tests of all modules. docs/extremes.md lists the properties that must hold.
namespace handwheel::test {

// Sizes of a part and positions of its centre (mm).
inline constexpr double kScales[] = {1e-6, 1e-3, 1.0, 1e3, 1e6};
inline constexpr double kOffsets[] = {0.0, 1e3, 1e5, 1e7};

// Returns numbers that formulas rarely handle: not finite, denormal, or at the limits of the type.
inline std::vector<double> strangeNumbers() {
  using Limits = std::numeric_limits<double>;
  return {Limits::quiet_NaN(),
          Limits::infinity(),
          -Limits::infinity(),
          Limits::denorm_min(),
          -1e-310,
          Limits::min(),
          Limits::max(),
          Limits::lowest(),
          -0.0,
          1e300};
}

// A mesh with its properties known by construction.
struct ExtremeMesh {
  std::string name;
  std::function<TriangleSoup()> soup;
  std::size_t components = 1;
  std::size_t loops = 0;       // number of chains of open edges
  std::size_t filled = 0;      // number of loops that a repair closes
  std::size_t degenerate = 0;  // number of triangles without area
  bool oriented = true;        // true if the faces of the file are oriented consistently
  bool flat = false;           // an open sheet in a plane; on request, a repair turns it into a thin body
  bool sound = true;           // true if the mesh is closed, manifold and oriented after a repair
  std::optional<double> volume = std::nullopt;  // volume of a sound mesh after a repair, mm³
  double volumeError = 1e-9;                    // relative error of the volume
};

inline constexpr double kNothing = 1e-150;  // mm; squares of shorter lengths underflow

// Returns the largest extent of a mesh (mm). The result is above zero, even if the mesh is empty or squares overflow or
// underflow.
inline double lengthOf(const TriangleSoup& soup) {
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  const double length = box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
  return length > 0.0 ? length : 1.0;
}

// Returns triangles with all corners at the same position.
inline TriangleSoup coincident(std::size_t triangles) {
  TriangleSoup s;
  s.points.assign(3 * triangles, Vec3(1, 2, 3));
  for (std::uint32_t i = 0; i < triangles; ++i) s.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return s;
}

// Returns triangles without area whose corners are on one line.
inline TriangleSoup collinear(std::size_t triangles) {
  TriangleSoup s;
  for (std::uint32_t i = 0; i < triangles + 2; ++i) s.points.emplace_back(i, 2 * i, 3 * i);
  for (std::uint32_t i = 0; i < triangles; ++i) s.triangles.push_back({i, i + 1, i + 2});
  return s;
}

// Returns a closed bar of this length, with a square section of 1 × 1. Its long sides are slivers from end to end.
inline TriangleSoup sliverBar(double length) {
  TriangleSoup s = cube();
  for (Vec3& p : s.points) p.z() *= length;
  return s;
}

// Returns a closed unit cube with needles without area along its edges.
inline TriangleSoup needleCube() {
  TriangleSoup s = cube();
  for (std::size_t f = 0; f < 4; ++f) addNeedles(s, f, 0, {0.25, 0.5, 1.0 - 1e-9});
  return s;
}

// Returns this number of separate tetrahedra of volume 1/6, on a grid.
inline TriangleSoup scattered(std::uint32_t parts) {
  TriangleSoup s;
  const auto side = static_cast<std::uint32_t>(std::ceil(std::cbrt(parts)));
  s.points.reserve(4 * parts);
  for (std::uint32_t i = 0; i < parts; ++i) {
    append(s, moved(tetrahedron(), 2.0 * Vec3(i % side, i / side % side, i / side / side)));
  }
  return s;
}

// Returns at least this number of triangles on a torus with holes of four edges each. Its volume without holes is
// 2π² · 50 · 20² mm³.
inline TriangleSoup largeTorus(std::size_t triangles, std::size_t holes) {
  const auto n = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(triangles + 2 * holes) / 2.0)));
  TriangleSoup s = torus(n, n, 50.0, 20.0);
  const std::size_t every = s.triangles.size() / holes / 2 * 2;  // the two triangles of a cell are removed together
  for (std::size_t i = 0; i < holes; ++i) s.triangles[i * every][0] = s.triangles[i * every + 1][0] = kNone;
  std::erase_if(s.triangles, [](const Triangle& t) { return t[0] == kNone; });
  return s;
}

// Returns spheres with three holes each, with radii from kScales and centres from kOffsets.
inline std::vector<ExtremeMesh> scaledMeshes() {
  std::vector<ExtremeMesh> meshes;
  const double sphere = 4.0 / 3.0 * M_PI;
  for (double scale : kScales) {
    meshes.push_back({"holed sphere of radius " + std::to_string(scale) + " mm",
                      [=] { return moved(sphereWithHoles(4, 3, 0.3), Vec3::Zero(), scale); }});
    meshes.back().volume = sphere * scale * scale * scale;
  }
  for (double offset : kOffsets) {
    meshes.push_back({"holed sphere of radius 10 mm, " + std::to_string(static_cast<int>(offset)) + " mm away",
                      [=] { return moved(sphereWithHoles(4, 3, 0.3), Vec3(offset, -offset, offset), 10.0); }});
    meshes.back().volume = sphere * 1000.0;
  }
  for (ExtremeMesh& mesh : meshes) {
    mesh.loops = mesh.filled = 3;
    mesh.volumeError = 0.01;  // the triangles and the patches are flat, unlike the sphere
  }
  return meshes;
}

// Returns closed surfaces of unusual triangles, and degenerate input that is hardly a surface.
inline std::vector<ExtremeMesh> oddMeshes() {
  return {
      {.name = "needles", .soup = needleCube, .degenerate = 12, .volume = 1.0},
      {.name = "slivers 1e6 : 1", .soup = [] { return sliverBar(1e6); }, .volume = 1e6},
      {.name = "slivers 1 : 1e6", .soup = [] { return sliverBar(1e-6); }, .volume = 1e-6},
      {.name = "coincident points", .soup = [] { return coincident(100); }, .degenerate = 100, .sound = false},
      {.name = "zero areas only",
       .soup = [] { return collinear(100); },
       .loops = 1,
       .filled = 1,  // the loop is removed with its faces
       .degenerate = 100,
       .oriented = false,
       .sound = false},
      {.name = "points of its own for each triangle", .soup = [] { return unshared(icosphere(3)); }},
      {.name = "one triangle",
       .soup =
           [] {
             return TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
           },
       .loops = 1,
       .filled = 1,
       .flat = true},
      {.name = "nothing", .soup = [] { return TriangleSoup(); }, .components = 0, .sound = false},
      {.name = "denormal coordinates", .soup = [] { return moved(cube(), Vec3::Zero(), 1e-310); }},
      {.name = "squares that underflow", .soup = [] { return moved(cube(), Vec3::Zero(), 1e-170); }},
      {.name = "squares that overflow", .soup = [] { return moved(cube(), Vec3::Zero(), 1e170); }},
  };
}

// Returns one-sided and open meshes, and meshes of many parts.
inline std::vector<ExtremeMesh> topologicalMeshes() {
  return {
      {.name = "open sheet", .soup = [] { return disc(60, 10); }, .loops = 1, .filled = 1, .flat = true},
      {.name = "open sheet with a hole",
       .soup = [] { return annulus(60, 10, 0.2, 1.0); },
       .loops = 2,
       .filled = 2,
       .flat = true},
      {.name = "ball whose hole has a folded boundary",
       .soup = [] { return withFoldedBorder(withHole(icosphere(4), Vec3(1, 2, 3).normalized(), 0.15)); },
       .loops = 1,
       .filled = 1,
       .volume = 4.0 / 3.0 * std::numbers::pi,
       .volumeError = 0.01},  // the triangles and the patch are flat, and folds remain
      {.name = "Möbius strip",
       .soup = [] { return moebiusStrip(60, 4); },
       .loops = 1,
       .filled = 2,  // both parts of the boundary at the cut; a body around the strip has two sides
       .oriented = false},
      {.name = "Klein bottle", .soup = [] { return kleinBottle(60, 30); }, .oriented = false, .sound = false},
      {.name = "sphere with a cross cap", .soup = [] { return sphereWithCrossCap(5); }, .oriented = false},
      {.name = "100,000 components",
       .soup = [] { return scattered(100'000); },
       .components = 100'000,
       .volume = 100'000 / 6.0},
      {.name = "fan of 20,000 triangles", .soup = [] { return uvSphere(20'000, 3); }},
  };
}

inline std::vector<ExtremeMesh> allMeshes() {
  std::vector<ExtremeMesh> all = scaledMeshes();
  for (const auto& more : {oddMeshes(), topologicalMeshes()}) all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace handwheel::test
