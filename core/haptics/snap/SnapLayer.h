// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "haptics/snap/SnapItem.h"
#include "proximity/BoxQueries.h"
#include "proximity/TriangleBoxes.h"

#include <vector>

namespace handwheel {

// Lower bound of the squared distance from a point to a box. It is computed like PointToBox, but in single precision
// and on all axes at once, for the servo thread. It never exceeds the squared distance to an object in the box.
class SnapBound {
 public:
  explicit SnapBound(const Vec3& p) {
    // The margin is the same as in BoxFrame::around(), and covers the rounding to float.
    const double margin = std::ldexp(p.cwiseAbs().maxCoeff(), -22) + 1e-37;
    m_low.head<3>() = (p.array() - margin).cast<float>();
    m_high.head<3>() = (p.array() + margin).cast<float>();
  }

  double squaredDistance(const FloatBox& box) const {
    const Eigen::Array4f d = (box.low - m_high).max(m_low - box.high).max(0.0f);
    // In double precision the squares neither overflow nor vanish. The fourth element of a row is no coordinate.
    const double x = d[0], y = d[1], z = d[2];
    return (x * x + y * y + z * z) * (1.0 - 1e-6);
  }

 private:
  Eigen::Array4f m_low = Eigen::Array4f::Ones(), m_high = Eigen::Array4f::Ones();
};

// Bounding volume hierarchy over the snap items of one dimension. Queries are for the servo thread, and do not
// allocate, lock or make system calls. They take time proportional to the number of items nearby, and to the logarithm
// of the number of other items. They begin with the nearest boxes and end after kMostItems items.
class SnapLayer {
 public:
  // Largest number of items visited by a query, which takes a fraction of a millisecond. It is not a fidelity setting,
  // but guards the duration of a tick; results that it cuts short are marked. The number of features that act at once
  // is the fidelity setting snap.features.
  static constexpr std::uint32_t kMostItems = 4096;

  // Result of a nearest-item query.
  struct Hold {
    std::uint32_t item = kNone;
    Vec3 point = Vec3::Zero();   // point on the item nearest to the tip
    double handDistance = 0.0;   // mm, between the item and the tip
    double proxyDistance = 0.0;  // mm, between the item and the proxy
    bool isCutShort = false;     // true: a better item may exist
  };
  // Parameters of a nearest-item query. `hand` is the position of the device tip, and `proxy` that of the proxy, mm.
  struct Reach {
    Vec3 hand = Vec3::Zero();
    Vec3 proxy = Vec3::Zero();
    double distance = 0.0;   // mm: items further from the tip are ignored
    double fromProxy = 0.0;  // mm: items further from the proxy are ignored
    double tie = 0.0;        // mm: distances that differ by less are equal
    SnapFeature held = {};   // feature that is preferred if all else is equal
    bool onlyHeld = false;   // true: only the held feature is considered
  };

  SnapLayer() = default;
  // The layer is empty if the construction was cancelled.
  SnapLayer(std::span<const SnapItem> items, const BoxFrame& frame, Progress progress);

  bool empty() const { return m_items.empty(); }
  const SnapItem& item(std::uint32_t i) const { return m_items[i]; }

  // Returns the item nearest to the proxy. Of equally near items, it is the one nearest to the tip; among these the
  // held one, and then the one with the lowest number. The item is kNone if no item is in reach.
  Hold nearest(const Reach& reach) const;

  // Calls visit(item, nearest point of the item, squared distance) for the items whose squared distance from p is less
  // than limit(), which may decrease during the query. Returns false if kMostItems was reached.
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

  std::vector<SnapItem> m_items;  // the items in the order of the leaves
  BoxFrame m_frame;
  BoxTree m_tree;
};

}  // namespace handwheel
