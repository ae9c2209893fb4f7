// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "proximity/TriangleBoxes.h"

#include "proximity/TriangleIntersection.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

// The middle value of each coordinate over a sample: unlike the middle of the bounds it ignores strays.
Vec3 medianOf(std::span<const Vec3> points) {
  const std::size_t step = std::max<std::size_t>(1, points.size() / 1000);
  Vec3 median = Vec3::Zero();
  std::vector<double> values;
  for (int k = 0; k < 3; ++k) {
    values.clear();
    for (std::size_t i = 0; i < points.size(); i += step)
      if (std::isfinite(points[i][k])) values.push_back(points[i][k]);
    if (values.empty()) continue;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[k] = *middle;
  }
  return median;
}

}  // namespace

BoxFrame::BoxFrame(std::span<const Vec3> points) {
  const Vec3 middle = medianOf(points);
  double reach = 0.0;
  for (const Vec3& p : points)
    for (int k = 0; k < 3; ++k)
      if (const double d = std::abs(p[k] * 0.5 - middle[k] * 0.5); std::isfinite(d)) reach = std::max(reach, d);
  if (reach == 0.0) {
    m_shift = middle;
    return;
  }
  // Clamped so that neither a coordinate nor the scale itself leaves the range of double.
  m_scale = std::ldexp(1.0, std::clamp(-std::ilogb(reach) - 2, -1000, 1000));
  m_shift = middle * m_scale;
}

FloatBox BoxFrame::around(const Vec3& a, const Vec3& b, const Vec3& c) const {
  const Vec3 u = toFrame(a), v = toFrame(b), w = toFrame(c);
  const Vec3 low = u.cwiseMin(v).cwiseMin(w);
  const Vec3 high = u.cwiseMax(v).cwiseMax(w);
  // 2^-22 less the rounding to float leaves at least 2^-23; the constant stands in where floats become subnormal.
  const double margin = std::ldexp(std::max(low.cwiseAbs().maxCoeff(), high.cwiseAbs().maxCoeff()), -22) + 1e-37;
  FloatBox box{Eigen::Array4f::Zero(), Eigen::Array4f::Zero()};
  box.low.head<3>() = (low.array() - margin).cast<float>();
  box.high.head<3>() = (high.array() + margin).cast<float>();
  return box;
}

std::vector<BoxedItem> boxedTriangles(std::span<const Vec3> points, std::span<const Triangle> triangles,
                                      const BoxFrame& frame, FlatTriangles flat, Progress progress) {
  std::vector<BoxedItem> items(triangles.size());
  const tbb::blocked_range<std::size_t> all(0, triangles.size(), 4096);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    if (progress.cancelled()) return;
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Triangle& t = triangles[i];
      const Vec3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
      const bool wanted =
          a.allFinite() && b.allFinite() && c.allFinite() && (flat == FlatTriangles::Keep || !isDegenerate({a, b, c}));
      if (wanted) items[i].box = frame.around(a, b, c);
      items[i].setId(wanted ? static_cast<std::uint32_t>(i) : kNone);
    }
  });
  if (progress.cancelled()) return {};
  std::erase_if(items, [](const BoxedItem& item) { return item.id() == kNone; });
  return items;
}

}  // namespace handwheel
