// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <limits>
#include <span>
#include <vector>

namespace handwheel {

// A curve along which a tool is guided by hand: a polyline. Immutable; any thread.
class GuideCurve {
 public:
  // points: mm; points that are not finite and repeated points are left out.
  explicit GuideCurve(std::span<const Vec3> points);

  bool isEmpty() const { return m_points.empty(); }
  std::span<const Vec3> points() const { return m_points; }
  double length() const { return m_along.empty() ? 0.0 : m_along.back(); }  // mm

  struct Nearest {
    Vec3 position = Vec3::Zero();
    double distance = std::numeric_limits<double>::infinity();  // mm
    double along = 0.0;                                         // mm from the beginning of the curve
  };
  // Returns the nearest point of a part of the curve, which is given by its arc lengths. An empty curve has none.
  // O(points).
  Nearest nearest(const Vec3& to, double from = 0.0, double until = std::numeric_limits<double>::infinity()) const;

  // Returns the position under a virtual fixture: a point nearer to the curve than the snap distance is drawn to it,
  // more strongly the nearer it is, and not at all at the snap distance, so that nothing leaps. A distance of the share
  // s of the snap distance becomes the share s³.
  Vec3 drawn(const Vec3& tool, double snapDistance) const;

 private:
  std::vector<Vec3> m_points;
  std::vector<double> m_along;  // arc length at each point, mm
};

// Deviation of a tool that was led along a curve, from its first approach to the beginning until the end (He 2008,
// chapter 6, compares vision, force, and force with fixture).
struct FollowingStatistics {
  double rms = 0.0;      // mm from the curve, over time
  double most = 0.0;     // mm
  double seconds = 0.0;  // duration from the beginning to the end
  double share = 0.0;    // share of the curve that was passed, 0 to 1
  bool isComplete() const { return share >= 1.0; }
};

// Measures one attempt to follow a curve, while it goes on. Only forward motion counts: after a point on the curve was
// reached, the nearest point is sought around it, so that a curve may cross itself or be closed.
class FollowingTry {
 public:
  // The curve must outlive it.
  explicit FollowingTry(const GuideCurve& curve) : m_curve(curve) {}

  // Adds the position of the tool at a time (s); times must not decrease. Positions after the end are ignored.
  void add(double time, const Vec3& tool);
  bool hasBegun() const { return m_begin >= 0.0; }
  bool isOver() const { return m_isOver; }
  double deviation() const { return m_deviation; }  // mm, at the last position
  FollowingStatistics figures() const;

 private:
  const GuideCurve& m_curve;
  double m_begin = -1.0, m_time = 0.0;  // s
  double m_along = 0.0;                 // mm
  double m_deviation = 0.0, m_most = 0.0, m_squares = 0.0;
  bool m_isOver = false;
};

}  // namespace handwheel
