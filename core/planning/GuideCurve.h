// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <limits>
#include <span>
#include <vector>

namespace handwheel {

// A curve that a tool is to be led along by hand: a polyline. Immutable; any thread.
class GuideCurve {
 public:
  // points: mm; those that are no numbers, and repeated ones, are left out.
  explicit GuideCurve(std::span<const Vec3> points);

  bool isEmpty() const { return m_points.empty(); }
  std::span<const Vec3> points() const { return m_points; }
  double length() const { return m_along.empty() ? 0.0 : m_along.back(); }  // mm

  struct Nearest {
    Vec3 place = Vec3::Zero();
    double distance = std::numeric_limits<double>::infinity();  // mm
    double along = 0.0;                                         // mm from the curve's begin
  };
  // The nearest place of a part of the curve, from and to so far along it. An empty curve has none. O(points).
  Nearest nearest(const Vec3& to, double from = 0.0, double until = std::numeric_limits<double>::infinity()) const;

  // A virtual fixture: what is nearer to the curve than the snap distance is drawn to it, the more the nearer it is; at
  // the snap distance not at all, so that nothing leaps. What is at a share s of that distance comes to the share s³.
  Vec3 drawn(const Vec3& place, double snapDistance) const;

 private:
  std::vector<Vec3> m_points;
  std::vector<double> m_along;  // mm, of each point
};

// How well a tool was led along a curve, from where it was first near to the begin until it was at the end (He 2008,
// chapter 6: eyes, force, force and fixture compared).
struct FollowingStatistics {
  double rms = 0.0;      // mm from the curve, over time
  double most = 0.0;     // mm
  double seconds = 0.0;  // from begin to end
  double share = 0.0;    // 0 to 1, of the curve that was passed
  bool isComplete() const { return share >= 1.0; }
};

// Measures a try while it goes on. Only what is led forward counts: after a place on the curve that was reached, the
// nearest one is sought around it, so that a curve may cross itself or be closed.
class FollowingTry {
 public:
  // The curve must outlive it.
  explicit FollowingTry(const GuideCurve& curve) : m_curve(curve) {}

  // Where the tool is at a time (s); times do not go back. After the end nothing counts.
  void add(double time, const Vec3& place);
  bool hasBegun() const { return m_begin >= 0.0; }
  bool isOver() const { return m_isOver; }
  double deviation() const { return m_deviation; }  // mm, of the last place
  FollowingStatistics figures() const;

 private:
  const GuideCurve& m_curve;
  double m_begin = -1.0, m_time = 0.0;  // s
  double m_along = 0.0;                 // mm
  double m_deviation = 0.0, m_most = 0.0, m_squares = 0.0;
  bool m_isOver = false;
};

}  // namespace handwheel
