// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Weld.h"

#include <bit>
#include <cstring>

namespace handwheel {
namespace {

std::uint64_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) {
    const double x = p[k] == 0.0 ? 0.0 : p[k];
    h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ull;
    h ^= h >> 32;
  }
  return h;
}

}  // namespace

PointClasses classifyPoints(std::span<const Vec3> points) {
  PointClasses result;
  result.classOf.resize(points.size());
  result.representative.reserve(points.size() / 4);
  // Open addressing at a load of at most one half; a slot holds a class.
  const std::size_t capacity = std::bit_ceil(2 * points.size() + 1);
  std::vector<std::uint32_t> slots(capacity, kNone);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::size_t slot = hash(points[i]) & (capacity - 1);
    while (slots[slot] != kNone && points[result.representative[slots[slot]]] != points[i]) {
      slot = (slot + 1) & (capacity - 1);
    }
    if (slots[slot] == kNone) {
      slots[slot] = static_cast<std::uint32_t>(result.representative.size());
      result.representative.push_back(static_cast<std::uint32_t>(i));
    }
    result.classOf[i] = slots[slot];
  }
  return result;
}

TriangleSoup weld(const TriangleSoup& soup) {
  const PointClasses classes = classifyPoints(soup.points);
  std::vector<std::uint32_t> number(classes.representative.size(), kNone);
  TriangleSoup welded;
  welded.triangles.reserve(soup.triangles.size());
  for (const Triangle& t : soup.triangles) {
    Triangle w;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t c = classes.classOf[t[k]];
      if (number[c] == kNone) {
        number[c] = static_cast<std::uint32_t>(welded.points.size());
        welded.points.push_back(soup.points[classes.representative[c]]);
      }
      w[k] = number[c];
    }
    welded.triangles.push_back(w);
  }
  return welded;
}

void roundPoints(TriangleSoup& soup, NumberType numbers) {
  for (Vec3& p : soup.points) p = rounded(p, numbers);
}

}  // namespace handwheel
