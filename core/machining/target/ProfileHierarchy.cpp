// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileHierarchy.h"

#include <limits>

namespace handwheel {

ProfileHierarchy::ProfileHierarchy(std::span<const ProfileSegment> segments) : m_count(segments.size()), m_boxes(1) {
  build(segments, 0, 0, m_count);
}

void ProfileHierarchy::build(std::span<const ProfileSegment> segments, std::size_t node, std::size_t first,
                             std::size_t last) {
  if (m_boxes.size() <= node) m_boxes.resize(node + 1);
  ProfileBox box;
  if (last - first <= kLeaf) {
    for (std::size_t i = first; i < last; ++i) box.extend(segments[i].box());
  } else {
    const std::size_t middle = first + (last - first) / 2;
    build(segments, 2 * node + 1, first, middle);
    build(segments, 2 * node + 2, middle, last);
    box = m_boxes[2 * node + 1].merged(m_boxes[2 * node + 2]);
  }
  m_boxes[node] = box;
}

ProfileHierarchy::Nearest ProfileHierarchy::nearest(std::span<const ProfileSegment> segments,
                                                    const ProfilePoint& p) const {
  Nearest best;
  best.distance = std::numeric_limits<double>::infinity();
  nearestBelow(segments, 0, 0, m_count, p, best);
  return best;
}

void ProfileHierarchy::nearestBelow(std::span<const ProfileSegment> segments, std::size_t node, std::size_t first,
                                    std::size_t last, const ProfilePoint& p, Nearest& best) const {
  if (last - first <= kLeaf) {
    for (std::size_t i = first; i < last; ++i) {
      const ProfilePoint point = segments[i].nearest(p);
      const double distance = (point - p).norm();
      if (distance < best.distance) best = {i, point, distance};
    }
    return;
  }
  const std::size_t middle = first + (last - first) / 2;
  const std::size_t low = 2 * node + 1, high = 2 * node + 2;
  const double toLow = m_boxes[low].exteriorDistance(p), toHigh = m_boxes[high].exteriorDistance(p);
  const bool isLowFirst = toLow <= toHigh;
  for (const bool isLow : {isLowFirst, !isLowFirst}) {
    if ((isLow ? toLow : toHigh) >= best.distance) continue;
    if (isLow) {
      nearestBelow(segments, low, first, middle, p, best);
    } else {
      nearestBelow(segments, high, middle, last, p, best);
    }
  }
}

}  // namespace handwheel
