// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapFeatures.h"

namespace handwheel {
namespace {

constexpr double kFarthestFeature = 1e100;  // so that nothing overflows when it is squared

bool isUsable(const Vec3& p) {
  return (p.array().abs() <= kFarthestFeature).all();  // not so for NaN
}

}  // namespace

void SnapFeatures::add(const SnapItem& item) {
  const auto& [a, b, c] = item.points;
  if (isUsable(a) && isUsable(b) && isUsable(c))
    m_items.push_back(item);
  else
    ++m_leftOut;
}

void SnapFeatures::addPoint(std::uint32_t id, const Vec3& p) {
  add({{p, p, p}, {SnapKind::Point, id}, SnapItem::Shape::Point});
}

void SnapFeatures::addSegment(std::uint32_t id, const Vec3& a, const Vec3& b) {
  add({{a, b, b}, {SnapKind::Segment, id}, SnapItem::Shape::Segment});
}

void SnapFeatures::addTriangle(std::uint32_t id, const Vec3& a, const Vec3& b, const Vec3& c) {
  add({{a, b, c}, {SnapKind::Facet, id}, SnapItem::Shape::Facet});
}

void SnapFeatures::addCurve(std::uint32_t id, std::span<const Vec3> points, bool isClosed) {
  std::vector<Vec3> line;
  for (const Vec3& p : points) {
    if (!isUsable(p)) {
      ++m_leftOut;
      return;
    }
    if (line.empty() || p != line.back()) line.push_back(p);
  }
  while (isClosed && line.size() > 1 && line.back() == line.front()) line.pop_back();
  if (line.empty()) return;
  const SnapFeature feature{SnapKind::Curve, id};
  const std::size_t n = line.size();
  if (n < 2) {
    add({{line[0], line[0], line[0]}, feature, SnapItem::Shape::Segment});
    return;
  }
  const bool isRing = isClosed && n > 2;
  for (std::size_t i = 0; i < (isRing ? n : n - 1); ++i) {
    const Vec3 &a = line[i], &b = line[(i + 1) % n];
    add({{a, b, b}, feature, SnapItem::Shape::Segment, {isRing || i > 0, isRing || i + 2 < n}});
  }
  for (std::size_t i = isRing ? 0 : 1; i < (isRing ? n : n - 1); ++i)
    add({{line[i], line[(i + n - 1) % n], line[(i + 1) % n]}, feature, SnapItem::Shape::Joint});
}

}  // namespace handwheel
