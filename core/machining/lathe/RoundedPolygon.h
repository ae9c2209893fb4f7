// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/ProfileCurve.h"

#include <array>
#include <span>

namespace handwheel {

// A convex polygon offset by a radius, in (r, z), mm. It is the section of a tool or of a part of the lathe. With a
// radius of 0 its corners are sharp. A polygon of one corner is a disc, or a point.
class RoundedPolygon {
 public:
  static constexpr std::size_t kMostCorners = 12;

  // Creates an empty polygon, which covers nothing.
  RoundedPolygon() = default;
  // Creates the convex hull of points, offset by a radius. There must be at most kMostCorners points, all finite, and
  // the radius must be finite and not negative. isSound() checks these conditions.
  RoundedPolygon(std::span<const ProfilePoint> corners, double radius);
  static bool isSound(std::span<const ProfilePoint> corners, double radius);

  bool empty() const { return m_count == 0; }
  // Returns the corners without repetition. They are counterclockwise with z to the right and r up.
  std::span<const ProfilePoint> corners() const { return {m_corners.data(), m_count}; }
  double radius() const { return m_radius; }

  RoundedPolygon moved(const ProfilePoint& by) const;
  // Returns the polygon mirrored in the axis.
  RoundedPolygon mirrored() const;
  // Returns the boundary as a closed polyline. perCircle: the number of points for a full circle.
  std::vector<ProfilePoint> outline(int perCircle) const;

  bool operator==(const RoundedPolygon& other) const;

 private:
  std::array<ProfilePoint, kMostCorners> m_corners{};
  std::size_t m_count = 0;
  double m_radius = 0.0;
};

// The area that a section covers while it moves straight. The area is exact: it is the hull of the section at its first
// and last position. The positions are those of the origin of the section. A sweep allocates nothing.
class SectionSweep {
 public:
  // Creates the sweep of a section between two positions. If a position is not finite, the sweep covers nothing.
  SectionSweep(const RoundedPolygon& section, const ProfilePoint& from, const ProfilePoint& to);

  bool empty() const { return m_lower.count == 0; }
  double first() const { return m_first; }  // mm, least z
  double last() const { return m_last; }    // mm, largest z
  double least() const { return m_least; }  // mm, least r of the whole sweep
  double largest() const { return m_largest; }

  // Return the least and the largest r of the sweep at this z, which must be within first() and last(). O(corners).
  double lowest(double z) const { return m_lower.at(z, m_radius); }
  double highest(double z) const { return -m_upper.at(z, m_radius); }

 private:
  // The side of the hull that faces the axis, from the least z to the largest. The other side is stored mirrored.
  struct Chain {
    std::array<ProfilePoint, 2 * RoundedPolygon::kMostCorners> points{};
    std::size_t count = 0;
    void add(const ProfilePoint& p);
    double at(double z, double radius) const;
  };

  Chain m_lower, m_upper;
  double m_radius = 0.0;
  double m_first = 0.0, m_last = -1.0;
  double m_least = 0.0, m_largest = 0.0;
};

}  // namespace handwheel
