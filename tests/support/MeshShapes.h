// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

// Generated shapes for tests. Closed shapes face outward, and neighbouring triangles share points, unless the comment
// of a shape says otherwise.
namespace handwheel::test {

// Returns a grid of the points point(i, j) with i < rows and j < columns, each cell cut into two triangles. If rows or
// columns wrap round, their last line of points is joined to the first. Seen with i to the right and j upwards, the
// faces are counter-clockwise.
template <class Point>
TriangleSoup grid(std::uint32_t rows, std::uint32_t columns, bool rowsWrap, bool columnsWrap, Point point) {
  TriangleSoup s;
  for (std::uint32_t i = 0; i < rows; ++i) {
    for (std::uint32_t j = 0; j < columns; ++j) s.points.push_back(point(i, j));
  }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return (i % rows) * columns + j % columns; };
  for (std::uint32_t i = 0; i + 1 < rows + (rowsWrap ? 1 : 0); ++i) {
    for (std::uint32_t j = 0; j + 1 < columns + (columnsWrap ? 1 : 0); ++j) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

inline void append(TriangleSoup& s, const TriangleSoup& other) {
  const auto offset = static_cast<std::uint32_t>(s.points.size());
  s.points.insert(s.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles) s.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

inline TriangleSoup moved(TriangleSoup s, const Vec3& shift, double scale = 1.0) {
  for (Vec3& p : s.points) p = scale * p + shift;
  return s;
}

inline TriangleSoup turnedOver(TriangleSoup s) {
  for (Triangle& t : s.triangles) std::swap(t[1], t[2]);
  return s;
}

// Returns the triangles with unshared points, as in an STL file.
inline TriangleSoup unshared(const TriangleSoup& s) {
  TriangleSoup r;
  for (const Triangle& t : s.triangles) {
    const auto n = static_cast<std::uint32_t>(r.points.size());
    for (std::uint32_t v : t) r.points.push_back(s.points[v]);
    r.triangles.push_back({n, n + 1, n + 2});
  }
  return r;
}

// Returns a cube whose least corner is given, with two triangles per side.
inline TriangleSoup cube(double size = 1.0, const Vec3& corner = Vec3::Zero()) {
  TriangleSoup s;
  for (int i = 0; i < 8; ++i) s.points.push_back(corner + size * Vec3(i & 1, (i >> 1) & 1, (i >> 2) & 1));
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

// Returns a box along the axes whose least corner is given.
inline TriangleSoup box(const Vec3& corner, const Vec3& size) {
  TriangleSoup s = cube();
  for (Vec3& p : s.points) p = corner + p.cwiseProduct(size);
  return s;
}

// Returns the tetrahedron of the origin and the ends of the three unit vectors. Its volume is 1/6.
inline TriangleSoup tetrahedron() {
  return {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

// Returns a unit sphere around the origin, made of 20 · 4^levels triangles.
inline TriangleSoup icosphere(int levels) {
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  TriangleSoup s;
  for (const Vec3& p :
       {Vec3(-1, g, 0), Vec3(1, g, 0), Vec3(-1, -g, 0), Vec3(1, -g, 0), Vec3(0, -1, g), Vec3(0, 1, g), Vec3(0, -1, -g),
        Vec3(0, 1, -g), Vec3(g, 0, -1), Vec3(g, 0, 1), Vec3(-g, 0, -1), Vec3(-g, 0, 1)})
    s.points.push_back(p.normalized());
  s.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(s.points.size()));
      if (isNew) s.points.push_back((s.points[a] + s.points[b]).normalized());
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : s.triangles) {
      const std::uint32_t a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], a, c}, {t[1], b, a}, {t[2], c, b}, {a, b, c}});
    }
    s.triangles = finer;
  }
  return s;
}

// Returns a sphere with its poles on the z axis, n meridians, and m - 1 rings between the poles.
inline TriangleSoup uvSphere(std::uint32_t n, std::uint32_t m) {
  TriangleSoup s = grid(n, m - 1, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n, v = M_PI * (j + 1) / m - M_PI / 2.0;
    return Vec3(std::cos(v) * std::cos(u), std::cos(v) * std::sin(u), std::sin(v));
  });
  const auto south = static_cast<std::uint32_t>(s.points.size()), north = south + 1;
  s.points.insert(s.points.end(), {Vec3(0, 0, -1), Vec3(0, 0, 1)});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = i * (m - 1), b = (i + 1) % n * (m - 1);
    s.triangles.push_back({south, b, a});
    s.triangles.push_back({north, a + m - 2, b + m - 2});
  }
  return s;
}

inline TriangleSoup torus(std::uint32_t n, std::uint32_t m, double large = 2.0, double small = 0.7) {
  return grid(n, m, true, true, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n, v = 2.0 * M_PI * j / m, r = large + small * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), small * std::sin(v));
  });
}

// Returns a cylinder around the z axis from z = 0 to the height, with n cells around and m cells along the axis. If it
// is closed, each end is a fan of triangles around its centre.
inline TriangleSoup cylinder(std::uint32_t n, std::uint32_t m, double radius, double height, bool closed) {
  TriangleSoup s = grid(n, m + 1, true, false, [&](std::uint32_t i, std::uint32_t j) {
    const double u = 2.0 * M_PI * i / n;
    return Vec3(radius * std::cos(u), radius * std::sin(u), height * j / m);
  });
  if (!closed) return s;
  const auto low = static_cast<std::uint32_t>(s.points.size()), high = low + 1;
  s.points.insert(s.points.end(), {Vec3(0, 0, 0), Vec3(0, 0, height)});
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = i * (m + 1), b = (i + 1) % n * (m + 1);
    s.triangles.push_back({low, b, a});
    s.triangles.push_back({high, a + m, b + m});
  }
  return s;
}

// Returns a flat ring in z = 0, facing +z.
inline TriangleSoup annulus(std::uint32_t n, std::uint32_t rings, double inner, double outer) {
  return grid(rings + 1, n, false, true, [&](std::uint32_t i, std::uint32_t j) {
    const double r = inner + (outer - inner) * i / rings, u = 2.0 * M_PI * j / n;
    return Vec3(r * std::cos(u), r * std::sin(u), 0.0);
  });
}

inline TriangleSoup disc(std::uint32_t n, std::uint32_t rings, double radius = 1.0) {
  TriangleSoup s = annulus(n, rings - 1, radius / rings, radius);
  const auto middle = static_cast<std::uint32_t>(s.points.size());
  s.points.push_back(Vec3::Zero());
  for (std::uint32_t j = 0; j < n; ++j) s.triangles.push_back({middle, j, (j + 1) % n});
  return s;
}

// Returns a sphere with a radius from 0.8 to 1.2. It does not intersect itself, as each ray from the origin meets it
// once.
inline TriangleSoup bumpySphere(int levels) {
  TriangleSoup s = icosphere(levels);
  for (Vec3& p : s.points) {
    p *= 1.0 + 0.2 * std::sin(4 * p.x() + 1) * std::sin(3 * p.y() + 2) * std::sin(5 * p.z() + 3);
  }
  return s;
}

inline TriangleSoup twoCubesSharingAnEdge() {
  TriangleSoup s = cube();
  append(s, cube(1.0, Vec3(1, 1, 0)));
  return s;
}

inline TriangleSoup twoCubesSharingAVertex() {
  TriangleSoup s = cube();
  append(s, cube(1.0, Vec3(1, 1, 1)));
  return s;
}

// Returns two closed cones, each with n triangles around its tip and a corner in its outline. They share the edge from
// the tip to that corner.
inline TriangleSoup twoConesSharingAnEdge(std::uint32_t n) {
  TriangleSoup s;
  for (const double side : {1.0, -1.0}) {
    TriangleSoup cone{{Vec3::Zero(), Vec3(side, 0, 1)}, {}};
    for (std::uint32_t i = 0; i < n; ++i) {
      const double u = 2.0 * M_PI * i / n;
      cone.points.emplace_back(side * (1.0 - std::cos(u)), std::sin(u) * std::sin(u / 2), 1.0);
      const std::uint32_t a = 2 + i, b = 2 + (i + 1) % n;
      cone.triangles.insert(cone.triangles.end(), {{0, b, a}, {1, a, b}});
    }
    append(s, side > 0 ? turnedOver(cone) : cone);
  }
  return s;
}

// Returns two rooms: a box twice as long as high, with one wall of two triangles across its middle.
inline TriangleSoup boxWithInnerWall() {
  TriangleSoup s = cube();
  std::erase_if(s.triangles, [&](const Triangle& t) {  // removes the side x = 1
    return s.points[t[0]].x() + s.points[t[1]].x() + s.points[t[2]].x() == 3.0;
  });
  TriangleSoup right = cube(1.0, Vec3(1, 0, 0));
  append(s, right);  // the side x = 1 of this box is the wall
  return s;
}

// Returns the boundary of random unit cells in a cube with `side` cells along each edge. The blocks may touch at faces,
// edges and corners. Points are not shared.
inline TriangleSoup randomBlocks(std::mt19937& random, std::size_t cells, std::uint32_t side) {
  std::set<std::array<int, 3>> filled;
  for (std::size_t i = 0; i < cells; ++i)
    filled.insert({int(random() % side), int(random() % side), int(random() % side)});
  TriangleSoup s;
  for (const auto& [x, y, z] : filled) {
    const TriangleSoup block = unshared(cube(1.0, Vec3(x, y, z)));
    for (const Triangle& t : block.triangles) {
      const std::array<Vec3, 3> p = {block.points[t[0]], block.points[t[1]], block.points[t[2]]};
      const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
      if (filled.contains({x + int(normal.x()), y + int(normal.y()), z + int(normal.z())})) continue;
      const auto n = static_cast<std::uint32_t>(s.points.size());
      s.points.insert(s.points.end(), p.begin(), p.end());
      s.triangles.push_back({n, n + 1, n + 2});
    }
  }
  return s;
}

// Returns n unit vectors with a nearly uniform distribution over the sphere.
inline std::vector<Vec3> directions(int n) {
  std::vector<Vec3> result;
  for (int i = 0; i < n; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / n, u = M_PI * (3.0 - std::sqrt(5.0)) * i, r = std::sqrt(1.0 - z * z);
    result.emplace_back(r * std::cos(u), r * std::sin(u), z);
  }
  return result;
}

// Returns a soup without the triangles that have a corner closer to the centre than the radius.
inline TriangleSoup withHole(TriangleSoup s, const Vec3& centre, double radius) {
  std::erase_if(s.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return (s.points[v] - centre).norm() < radius; });
  });
  return s;
}

// Returns a unit sphere without a cap around its +z pole.
inline TriangleSoup sphereWithoutCap(int levels, double radius = 0.4) {
  return withHole(icosphere(levels), Vec3::UnitZ(), radius);
}

inline TriangleSoup sphereWithHoles(int levels, int holes, double radius) {
  TriangleSoup s = icosphere(levels);
  for (const Vec3& d : directions(holes)) s = withHole(std::move(s), d, radius);
  return s;
}

// Splits triangle f at points on its edge from this corner, given by ascending fractions of the edge. Needles without
// area fill the gap between the old edge and its parts, so that a closed surface stays closed.
inline void addNeedles(TriangleSoup& s, std::size_t f, int corner, const std::vector<double>& fractions) {
  const Triangle t = s.triangles[f];
  const std::uint32_t a = t[corner], b = t[(corner + 1) % 3], apex = t[(corner + 2) % 3];
  std::vector<std::uint32_t> chain{a};
  for (double w : fractions) {
    chain.push_back(static_cast<std::uint32_t>(s.points.size()));
    s.points.push_back((1.0 - w) * s.points[a] + w * s.points[b]);
  }
  chain.push_back(b);
  s.triangles[f] = {chain[0], chain[1], apex};
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    s.triangles.push_back({chain[i], chain[i + 1], apex});
    s.triangles.push_back({a, chain[i + 1], chain[i]});
  }
}

// Returns random triangles over the points of a small grid. Many of them share edges, coincide or have no area.
inline TriangleSoup randomSoup(std::mt19937& random, std::size_t triangles, std::uint32_t steps) {
  TriangleSoup s;
  const auto coordinate = [&] { return static_cast<double>(random() % steps); };
  for (std::uint32_t i = 0; i < 3 * triangles; ++i) s.points.emplace_back(coordinate(), coordinate(), coordinate());
  for (std::uint32_t i = 0; i < triangles; ++i) s.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  return s;
}

}  // namespace handwheel::test
