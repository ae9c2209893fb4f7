// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "haptics/snap/SnapItem.h"
#include "proximity/BoxQueries.h"
#include "proximity/TriangleBoxes.h"

#include <vector>

namespace handwheel {

// Lower bound of the squared distance from a point to a box. Like PointToBox, but in single precision and on all axes
// at once, for the servo thread: never more than the squared distance of what is in the box.
class SnapBound {
 public:
  explicit SnapBound(const Vec3& p) {
    // The same margin as in BoxFrame::around(): it covers the rounding to float.
    const double margin = std::ldexp(p.cwiseAbs().maxCoeff(), -22) + 1e-37;
    m_low.head<3>() = (p.array() - margin).cast<float>();
    m_high.head<3>() = (p.array() + margin).cast<float>();
  }

  double squaredDistance(const FloatBox& box) const {
    const Eigen::Array4f d = (box.low - m_high).max(m_low - box.high).max(0.0f);
    // In double precision they neither overflow nor vanish. The fourth element of a row is no coordinate.
    const double x = d[0], y = d[1], z = d[2];
    return (x * x + y * y + z * z) * (1.0 - 1e-6);
  }

 private:
  Eigen::Array4f m_low = Eigen::Array4f::Ones(), m_high = Eigen::Array4f::Ones();
};

// Bounding volume hierarchy over the snap items of one dimension. Queries do not allocate, lock or make system calls:
// they are for the servo thread. They take time proportional to what is near, and to the logarithm of the rest; they
// end after kMostItems items, having begun with the nearest boxes.
class SnapLayer {
 public:
  // Largest number of items visited by a query, which takes a fraction of a millisecond. Not a fidelity setting, but
  // the guard of a tick: results that it cuts short say so. The number of features that count is the fidelity setting
  // snap.features.
  static constexpr std::uint32_t kMostItems = 4096;

  // Result of a nearest-item query.
  struct Hold {
    std::uint32_t item = kNone;
    Vec3 point = Vec3::Zero();   // on the item, nearest to the tip
    double handDistance = 0.0;   // mm
    double proxyDistance = 0.0;  // mm, between the item and the proxy
    bool isCutShort = false;     // there may be a better one
  };
  // Parameters of a nearest-item query. hand: position of the device tip, mm.
  struct Reach {
    Vec3 hand = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    double distance = 0.0;   // mm: items further from the tip are ignored,
    double fromProxy = 0.0;  // and items further than this from the proxy
    double tie = 0.0;        // mm: distances that differ by less are equal
    SnapFeature held = {};   // preferred when all else is equal
    bool onlyHeld = false;   // only the held feature is considered
  };

  SnapLayer() = default;
  // Empty if cancelled.
  SnapLayer(std::span<const SnapItem> items, const BoxFrame& frame, Progress progress);

  bool empty() const { return m_items.empty(); }
  const SnapItem& item(std::uint32_t i) const { return m_items[i]; }

  // Returns the item nearest to the proxy; of those equally near the one nearest to the tip, then the one that is held,
  // then the one with the lowest number. The item is kNone if nothing is in reach.
  Hold nearest(const Reach& reach) const;

  // Calls visit(item, its nearest point, squared distance) for the items nearer to p than the square root of limit(),
  // which may decrease in the course of this. Returns false if kMostItems was reached.
  template <class Limit, class Visit>
  bool forEachNear(const Vec3& p, Limit limit, Visit visit) const {
    const SnapBound point(m_frame.toFrame(p));
    const double scale2 = m_frame.scale() * m_frame.scale();
    std::uint32_t seen = 0;
    visitBestFirst(
        m_tree, [&](const FloatBox& box) { return point.squaredDistance(box); },
        [&] { return seen < kMostItems ? limit() * scale2 : -1.0; },
        [&](std::uint32_t begin, std::uint32_t end) {
          seen += end - begin;
          for (std::uint32_t i = begin; i < end; ++i) {
            const Vec3 closest = m_items[i].closestTo(p);
            const double distance2 = (closest - p).squaredNorm();
            if (distance2 < limit()) visit(m_items[i], closest, distance2);
          }
        });
    return seen < kMostItems;
  }

 private:
  bool isBetter(const Hold& a, const Hold& b, const Reach& reach) const;

  std::vector<SnapItem> m_items;  // in the order of the leaves
  BoxFrame m_frame;
  BoxTree m_tree;
};

}  // namespace handwheel
