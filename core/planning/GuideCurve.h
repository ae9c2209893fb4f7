// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <limits>
#include <span>
#include <vector>

namespace handwheel {

// A polyline along which a tool is guided by hand. It is immutable and may be used on any thread.
class GuideCurve {
 public:
  // Makes a curve of points (mm). Repeated points and points that are not finite are omitted.
  explicit GuideCurve(std::span<const Vec3> points);

  bool isEmpty() const { return m_points.empty(); }
  std::span<const Vec3> points() const { return m_points; }
  double length() const { return m_along.empty() ? 0.0 : m_along.back(); }  // mm

  struct Nearest {
    Vec3 position = Vec3::Zero();
    double distance = std::numeric_limits<double>::infinity();  // mm
    double along = 0.0;                                         // mm: arc length from the beginning of the curve
  };
  // Returns the point of the curve between two arc lengths (from, until; mm) that is nearest to a position. For an
  // empty curve the distance is infinite. O(points).
  Nearest nearest(const Vec3& to, double from = 0.0, double until = std::numeric_limits<double>::infinity()) const;

  // Returns the position of a tool under a virtual fixture. If the tool is nearer to the curve than the snap distance,
  // it is drawn to the curve: a distance of s times the snap distance becomes s³ times the snap distance, so that the
  // position is continuous.
  Vec3 drawn(const Vec3& tool, double snapDistance) const;

 private:
  std::vector<Vec3> m_points;
  std::vector<double> m_along;  // arc length at each point, mm
};

// Deviation of a tool that was led along a curve, from its arrival at the beginning of the curve to the end (He 2008,
// chapter 6, compares guidance by sight, by force, and by force with a virtual fixture).
struct FollowingStatistics {
  double rms = 0.0;      // mm: root mean square of the distance from the curve over time
  double most = 0.0;     // mm: largest distance from the curve
  double seconds = 0.0;  // duration from the beginning to the end
  double share = 0.0;    // fraction of the curve that was passed, 0…1
  bool isComplete() const { return share >= 1.0; }
};

// The measurement of one attempt to follow a curve. Once a point of the curve was reached, the nearest point is only
// sought in its neighbourhood, so that a curve may cross itself or be closed.
class FollowingTry {
 public:
  // Begins a measurement. The curve must outlive this object.
  explicit FollowingTry(const GuideCurve& curve) : m_curve(curve) {}

  // Adds the position of the tool at a time (s); times must not decrease. Positions after the end are ignored.
  void add(double time, const Vec3& tool);
  bool hasBegun() const { return m_begin >= 0.0; }
  bool isOver() const { return m_isOver; }
  double deviation() const { return m_deviation; }  // mm: distance from the curve at the last position
  FollowingStatistics figures() const;

 private:
  const GuideCurve& m_curve;
  double m_begin = -1.0, m_time = 0.0;  // s
  double m_along = 0.0;                 // mm
  double m_deviation = 0.0, m_most = 0.0, m_squares = 0.0;
  bool m_isOver = false;
};

}  // namespace handwheel
