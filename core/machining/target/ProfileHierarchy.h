// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <span>
#include <vector>

namespace handwheel {

// A hierarchy of boxes over the segments of a profile, in their order. It does not store the segments: the caller
// passes the segments that it was built from to each query.
class ProfileHierarchy {
 public:
  explicit ProfileHierarchy(std::span<const ProfileSegment> segments);

  struct Nearest {
    std::size_t segment = 0;
    ProfilePoint point{0, 0};
    double distance = 0.0;  // mm
  };
  // Returns the segment nearest to a point. There must be at least one segment. O(log segments) for a profile that does
  // not return to its own neighbourhood.
  Nearest nearest(std::span<const ProfileSegment> segments, const ProfilePoint& p) const;

  // Calls visit(i) with the index of each segment whose leaf may meet the box, until visit returns false.
  template <class Visit>
  void meeting(const ProfileBox& box, Visit visit) const {
    meetingBelow(0, 0, m_count, box, visit);
  }

 private:
  static constexpr std::size_t kLeaf = 4;  // number of segments in a leaf

  // Builds the boxes of a node and its children. Node k covers the segments [first, last); its halves are the nodes 2k
  // + 1 and 2k + 2.
  void build(std::span<const ProfileSegment> segments, std::size_t node, std::size_t first, std::size_t last);
  void nearestBelow(std::span<const ProfileSegment> segments, std::size_t node, std::size_t first, std::size_t last,
                    const ProfilePoint& p, Nearest& best) const;

  template <class Visit>
  bool meetingBelow(std::size_t node, std::size_t first, std::size_t last, const ProfileBox& box, Visit& visit) const {
    if (!m_boxes[node].intersects(box)) return true;
    if (last - first <= kLeaf) {
      for (std::size_t i = first; i < last; ++i)
        if (!visit(i)) return false;
      return true;
    }
    const std::size_t middle = first + (last - first) / 2;
    return meetingBelow(2 * node + 1, first, middle, box, visit) &&
           meetingBelow(2 * node + 2, middle, last, box, visit);
  }

  std::size_t m_count;
  std::vector<ProfileBox> m_boxes;
};

}  // namespace handwheel
