// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Surfaces.h"
#include "proximity/RayTriangle.h"
#include "proximity/TriangleHierarchy.h"

#include <rapidcheck.h>

// Queries for the tests of the hierarchy, on random surfaces.
namespace handwheel::test {

inline TriangleHierarchy hierarchyOf(const Surface& s) {
  return {s.points, s.triangles};
}

inline bool usable(const std::array<Vec3, 3>& t) {
  return t[0].allFinite() && t[1].allFinite() && t[2].allFinite();
}

inline std::optional<RayHit> bruteFirstHit(const Surface& s, const Vec3& origin, const Vec3& direction) {
  const RayTriangleTest test(origin, direction);
  std::optional<RayHit> best;
  for (std::uint32_t i = 0; i < s.triangles.size(); ++i) {
    const auto t = s.corners(i);
    const auto distance = usable(t) ? test.hit(t[0], t[1], t[2]) : std::nullopt;
    if (distance && (!best || *distance < best->distance)) best = RayHit{i, *distance};
  }
  return best;
}

inline rc::Gen<double> within(double low, double high) {
  return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()),
                      [=](std::uint32_t v) { return low + (high - low) * (v / 4294967296.0); });
}

inline Vec3 anyPoint(double low, double high) {
  return {*within(low, high), *within(low, high), *within(low, high)};
}

// A soup that was made in the unit cube, then scaled and shifted. The call operator moves a point in the same manner.
struct Placed {
  Surface surface;
  double scale;
  Vec3 shift;

  Vec3 operator()(const Vec3& p) const { return p * scale + shift; }
  Vec3 anyCorner() const { return surface.points[*rc::gen::inRange<std::size_t>(0, surface.points.size())]; }
};

inline Placed anySoup() {
  const auto count = *rc::gen::inRange<std::size_t>(1, 400);
  const double size = *rc::gen::element(0.02, 0.1, 0.7);
  const int steps = *rc::gen::element(0, 3, 16);
  const double scale = *rc::gen::element(1.0, 1e-6, 1e7);
  const Vec3 shift = *rc::gen::element(Vec3(0, 0, 0), Vec3(1e7, -1e7, 1e7));
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  return {moved(soup(count, size, steps, seed), scale, shift), scale, shift};
}

}  // namespace handwheel::test
