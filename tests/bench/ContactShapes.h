// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

// Surfaces for the contact benchmarks, with the typical flaws of scans.
namespace handwheel::bench {

constexpr double kBallRadius = 38.0;  // mm

// Returns the distance of the surface of a bumpy ball from its centre along a unit direction.
inline double bumpyRadius(const Vec3& d) {
  return kBallRadius * (1.0 + 0.03 * std::sin(9 * d.x()) * std::sin(8 * d.y() + 1) * std::sin(7 * d.z() + 2));
}

// Returns a ball made from a cube with n by n squares on each face: 12 n² triangles.
inline TriangleSoup ball(int n, const std::function<double(const Vec3&)>& radius) {
  TriangleSoup mesh;
  std::map<std::array<int, 3>, std::uint32_t> numbers;
  const auto corner = [&](int face, int i, int j) {
    const int a = 2 * i - n, b = 2 * j - n;
    const std::array<std::array<int, 3>, 6> axesOfFaces{
        {{n, a, b}, {-n, b, a}, {b, n, a}, {a, -n, b}, {a, b, n}, {b, a, -n}}};
    const std::array<int, 3> axes = axesOfFaces[static_cast<std::size_t>(face)];
    const auto [at, isNew] = numbers.try_emplace(axes, static_cast<std::uint32_t>(mesh.points.size()));
    if (isNew) {
      Vec3 d;
      for (int k = 0; k < 3; ++k) d[k] = std::tan(axes[static_cast<std::size_t>(k)] * M_PI / 4 / n);
      d.normalize();
      mesh.points.push_back(radius(d) * d);
    }
    return at->second;
  };
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const std::uint32_t a = corner(face, i, j), b = corner(face, i + 1, j), c = corner(face, i + 1, j + 1),
                            d = corner(face, i, j + 1);
        const bool odd = (i + j) % 2 == 1;
        mesh.triangles.push_back(odd ? Triangle{a, b, c} : Triangle{a, b, d});
        mesh.triangles.push_back(odd ? Triangle{a, c, d} : Triangle{b, c, d});
      }
  return mesh;
}

// Reverses every third triangle.
inline void turnSome(TriangleSoup& mesh) {
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
}

// Gives each triangle its own corners and moves each coordinate by up to this distance.
inline void shatter(TriangleSoup& mesh, double by) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> off(-by, by);
  TriangleSoup soup;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.points.size());
    for (const std::uint32_t v : t) soup.points.push_back(mesh.points[v] + Vec3(off(random), off(random), off(random)));
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  mesh = std::move(soup);
}

// Cuts the surface into sectors about the z axis, and narrows each sector by half the width on both sides.
inline void cutSeams(TriangleSoup& mesh, double width) {
  constexpr double kSector = 2 * M_PI / 20;
  TriangleSoup cut;
  std::map<std::pair<std::uint32_t, int>, std::uint32_t> numbers;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
    const int sector = static_cast<int>(std::floor((std::atan2(middle.y(), middle.x()) + M_PI) / kSector));
    Triangle corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [at, isNew] = numbers.try_emplace({t[k], sector}, static_cast<std::uint32_t>(cut.points.size()));
      corners[k] = at->second;
      if (!isNew) continue;
      Vec3 p = mesh.points[t[k]];
      const double angle = std::atan2(p.y(), p.x());
      const double side = std::remainder(angle - ((sector + 0.5) * kSector - M_PI), 2 * M_PI) / (kSector / 2);
      p -= 0.5 * width * side * Vec3(-std::sin(angle), std::cos(angle), 0.0);
      cut.points.push_back(p);
    }
    cut.triangles.push_back(corners);
  }
  mesh = std::move(cut);
}

// Splits every third triangle near a corner, which creates needles with an edge about a millionth of the triangle's
// size.
inline void addNeedles(TriangleSoup& mesh) {
  const std::size_t count = mesh.triangles.size();
  for (std::size_t i = 0; i < count; i += 3) {
    const Triangle t = mesh.triangles[i];
    const Vec3 beside = mesh.points[t[0]] + 1e-6 * (0.5 * (mesh.points[t[1]] + mesh.points[t[2]]) - mesh.points[t[0]]);
    const auto v = static_cast<std::uint32_t>(mesh.points.size());
    mesh.points.push_back(beside);
    mesh.triangles[i] = {t[0], t[1], v};
    mesh.triangles.push_back({v, t[1], t[2]});
    mesh.triangles.push_back({t[0], v, t[2]});
  }
}

}  // namespace handwheel::bench
