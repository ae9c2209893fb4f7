// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/ShapeSurfaces.h"

#include "robot/UrdfValues.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

TriangleSoup surface(const BoxShape& box, std::uint32_t) {
  TriangleSoup soup;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5);
    soup.points.emplace_back(sign.cwiseProduct(box.size));
  }
  for (const auto& [a, b, c, d] :
       {std::array{0u, 2u, 3u, 1u}, std::array{4u, 5u, 7u, 6u}, std::array{0u, 1u, 5u, 4u}, std::array{2u, 6u, 7u, 3u},
        std::array{0u, 4u, 6u, 2u}, std::array{1u, 3u, 7u, 5u}}) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
  }
  return soup;
}

// A surface of revolution about z: a pole, rings with the same number of points from the lowest to the highest, a pole.
struct Ring {
  double radius, z;
};
TriangleSoup revolved(double bottom, const std::vector<Ring>& rings, double top, std::uint32_t sides) {
  TriangleSoup soup;
  soup.points.emplace_back(0.0, 0.0, bottom);
  for (const Ring& ring : rings) {
    for (std::uint32_t i = 0; i < sides; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / sides;
      soup.points.emplace_back(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
    }
  }
  soup.points.emplace_back(0.0, 0.0, top);
  const auto last = static_cast<std::uint32_t>(soup.points.size() - 1);
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t here = 1 + i, next = 1 + (i + 1) % sides;
    soup.triangles.push_back({0, next, here});
    for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring) {
      const std::uint32_t a = here + ring * sides, b = next + ring * sides;
      soup.triangles.push_back({a, b, b + sides});
      soup.triangles.push_back({a, b + sides, a + sides});
    }
    const auto highest = static_cast<std::uint32_t>(rings.size() - 1) * sides;
    soup.triangles.push_back({here + highest, next + highest, last});
  }
  return soup;
}

TriangleSoup surface(const CylinderShape& cylinder, std::uint32_t sides) {
  const double z = 0.5 * cylinder.length;
  return revolved(-z, {{cylinder.radius, -z}, {cylinder.radius, z}}, z, sides);
}

TriangleSoup surface(const SphereShape& sphere, std::uint32_t sides) {
  std::vector<Ring> rings;
  const std::uint32_t belts = sides / 2;
  for (std::uint32_t i = 1; i < belts; ++i) {
    const double angle = std::numbers::pi * i / belts;
    rings.push_back({sphere.radius * std::sin(angle), -sphere.radius * std::cos(angle)});
  }
  return revolved(-sphere.radius, rings, sphere.radius, sides);
}

TriangleSoup surface(const MeshShape&, std::uint32_t) {
  return {};
}

}  // namespace

TriangleSoup surfaceOf(const Shape& shape, std::uint32_t sides) {
  assert(sides >= kLeastShapeSides);
  return std::visit([sides](const auto& s) { return surface(s, sides); }, shape);
}

void place(const MeshShape& shape, TriangleSoup& soup) {
  const Vec3 scale = shape.scale * kMillimetresPerMetre;
  for (Vec3& p : soup.points) p = p.cwiseProduct(scale);
  if ((scale.array() < 0.0).count() % 2 == 0) return;
  for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
}

}  // namespace handwheel
