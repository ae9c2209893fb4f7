// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapField.h"

#include <algorithm>
#include <tuple>

namespace handwheel {
namespace {

bool isLess(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
}

// The pieces of a curve belong together, and none of them may be removed.
bool isAlone(const SnapItem& item) {
  return item.feature.kind != SnapKind::Curve;
}

bool isLess(const SnapItem& a, const SnapItem& b) {
  if (isAlone(a) != isAlone(b)) return isAlone(a);
  if (a.shape != b.shape) return a.shape < b.shape;
  for (std::size_t i = 0; i < 3; ++i)
    if (a.points[i] != b.points[i]) return isLess(a.points[i], b.points[i]);
  return a.feature.id < b.feature.id;
}

// Equal features become one that counts as often, with the lowest number: thousands at one point cost as much as one.
void mergeEqual(std::vector<SnapItem>& items) {
  for (SnapItem& item : items) {
    // The points are in one order of the ends; those of a segment are the first and the repeated last.
    auto& p = item.points;
    const auto less = [](const Vec3& a, const Vec3& b) { return isLess(a, b); };
    if (item.shape == SnapItem::Shape::Facet) std::sort(p.begin(), p.end(), less);
    if (item.shape == SnapItem::Shape::Segment && isAlone(item) && isLess(p[1], p[0])) p = {p[1], p[0], p[0]};
  }
  std::sort(items.begin(), items.end(), [](const SnapItem& a, const SnapItem& b) { return isLess(a, b); });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    SnapItem* last = kept > 0 ? &items[kept - 1] : nullptr;
    if (last && isAlone(items[i]) && isAlone(*last) && last->shape == items[i].shape && last->points == items[i].points)
      last->weight += items[i].weight;
    else
      items[kept++] = items[i];
  }
  items.resize(kept);
}

}  // namespace

SnapField::SnapField(const SnapFeatures& features, Progress progress) {
  Box bounds;
  for (const SnapItem& item : features.items())
    for (const Vec3& p : item.points) bounds.extend(p);
  if (features.items().empty()) return;
  m_origin = bounds.center();
  std::array<std::vector<SnapItem>, kDimensions> items;
  std::vector<Vec3> points;
  for (SnapItem item : features.items()) {
    double largest = 0.0;
    for (Vec3& p : item.points) {
      p -= m_origin;
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    // The nearest point on it is computed; that of a point is exact.
    if (item.shape != SnapItem::Shape::Point)
      item.rounding = static_cast<float>(std::min(kQueryRounding * largest, 1e30));
    points.insert(points.end(), item.points.begin(), item.points.end());
    items[item.dimension()].push_back(item);
  }
  const BoxFrame frame(points);
  for (std::size_t d = 0; d < kDimensions; ++d) {
    if (progress.cancelled()) break;
    mergeEqual(items[d]);
    m_layers[d] = SnapLayer(items[d], frame, progress);
  }
  if (progress.cancelled()) m_layers = {};
}

bool SnapField::empty() const {
  return std::all_of(m_layers.begin(), m_layers.end(), [](const SnapLayer& layer) { return layer.empty(); });
}

}  // namespace handwheel
