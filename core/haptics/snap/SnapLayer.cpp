// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/SnapLayer.h"

#include <limits>

namespace handwheel {

SnapLayer::SnapLayer(std::span<const SnapItem> items, const BoxFrame& frame, Progress progress) : m_frame(frame) {
  std::vector<BoxedItem> boxed(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto& [a, b, c] = items[i].points;
    // A joint's neighbours are no part of it.
    boxed[i].box = items[i].shape == SnapItem::Shape::Joint ? frame.around(a, a, a) : frame.around(a, b, c);
    boxed[i].setId(static_cast<std::uint32_t>(i));
  }
  if (!m_tree.build(boxed, progress)) return;
  m_items.reserve(items.size());
  for (const BoxedItem& item : boxed) m_items.push_back(items[item.id()]);
}

SnapLayer::Hold SnapLayer::nearest(const Reach& reach) const {
  const SnapBound hand(m_frame.toFrame(reach.hand));
  const SnapBound proxy(m_frame.toFrame(reach.proxy));
  const bool isFree = reach.hand == reach.proxy;
  const double scale2 = m_frame.scale() * m_frame.scale();
  const double handLimit = reach.distance * reach.distance * scale2;
  Hold best;
  // distance of the best, and a tie
  double limit = isFree ? std::min(reach.fromProxy, reach.distance) : reach.fromProxy;
  std::uint32_t seen = 0;
  const auto look = [&](std::uint32_t i) {
    const SnapItem& item = m_items[i];
    if (item.shape == SnapItem::Shape::Joint || (reach.onlyHeld && item.feature != reach.held)) return;
    Hold hold{i, item.closestTo(reach.proxy)};
    const double rounding = item.rounding;
    const double proxyDistance2 = (hold.point - reach.proxy).squaredNorm();
    if (proxyDistance2 > (limit + rounding) * (limit + rounding)) return;
    const double distance = std::sqrt(proxyDistance2);
    hold.proxyDistance = std::max(0.0, distance - rounding);
    if (!isFree) hold.point = item.closestTo(reach.hand);
    hold.handDistance = isFree ? distance : (hold.point - reach.hand).norm();
    if (hold.handDistance > reach.distance) return;
    if (best.item == kNone || isBetter(hold, best, reach)) best = hold;
    limit = std::min(limit, hold.proxyDistance + reach.tie);
  };
  visitBestFirst(
      m_tree,
      [&](const FloatBox& box) {
        const bool isOut = !isFree && hand.squaredDistance(box) > handLimit;
        return isOut ? std::numeric_limits<double>::infinity() : proxy.squaredDistance(box);
      },
      [&] { return seen < kMostItems ? limit * limit * scale2 : -1.0; },
      [&](std::uint32_t begin, std::uint32_t end) {
        seen += end - begin;
        for (std::uint32_t i = begin; i < end; ++i) look(i);
      });
  best.isCutShort = seen >= kMostItems;
  return best;
}

bool SnapLayer::isBetter(const Hold& a, const Hold& b, const Reach& reach) const {
  if (std::abs(a.proxyDistance - b.proxyDistance) > reach.tie) return a.proxyDistance < b.proxyDistance;
  if (std::abs(a.handDistance - b.handDistance) > reach.tie) return a.handDistance < b.handDistance;
  const SnapFeature &f = m_items[a.item].feature, &g = m_items[b.item].feature;
  if ((f == reach.held) != (g == reach.held)) return f == reach.held;
  return f.id < g.id;
}

}  // namespace handwheel
