// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace handwheel {

// The parameters of a thread that a pass cuts. The work turns in step with the tool, and the tool leaves a groove
// between straight flanks. The bottom of the groove is as wide as the flat, and rounded into the flanks with the radius
// of the nose.
struct ThreadCut {
  static constexpr double kLeastPitch = 0.05, kLargestPitch = 100.0;  // mm
  static constexpr double kLeastAngle = 0.01, kLargestAngle = 3.0;    // radian
  static constexpr int kMostStarts = 64;

  double pitch = 1.0;         // mm, distance from groove to groove along the axis
  int starts = 1;             // number of parallel grooves; each rises by pitch · starts in a turn
  bool isLeft = false;        // true: left-hand thread
  double angle = M_PI / 3.0;  // radian, angle between the flanks
  double flat = 0.0;          // mm
  double offset = 0.0;        // mm, height of the middle of a groove in the half plane of +x

  double lead() const { return pitch * starts; }             // mm in a turn
  double rise() const { return isLeft ? -lead() : lead(); }  // mm per turn about +z
  bool isSound() const;                                      // true if all values are within the limits
  bool operator==(const ThreadCut&) const = default;

  // Returns the distance along the axis (mm, not negative) from the middle of the groove to its edge at a height above
  // the bottom. The function is the inverse of ThreadEdge::heightAt().
  double distanceAt(double height, double noseRadius) const;
};

// The edge of a groove in section. It consists of the bottom, an arc of the nose's radius, and the flank, each tangent
// to the next. An object stores the trigonometric values that all heights need.
class ThreadEdge {
 public:
  ThreadEdge(const ThreadCut& cut, double noseRadius);

  // Returns the height of the edge above the bottom, mm, at a distance along the axis (mm) from the middle of the
  // groove.
  double heightAt(double distance) const;

 private:
  double m_halfFlat, m_nose;
  double m_tangent, m_atTangent;  // end of the arc: its distance from the flat, and its height
  double m_slope;                 // tan of half the angle
};

// Returns the depth of the ISO metric profile, mm (ISO 68-1, with the rounded root of ISO 965-1, R = H/6). A groove of
// this depth, cut with a nose of radius isoMetricNose(), leaves a crest of P/8 and the thread's nominal pitch diameter.
inline double isoMetricDepth(double pitch) {
  return 17.0 / 24.0 * std::sqrt(3.0) / 2.0 * pitch;
}
inline double isoMetricInnerDepth(double pitch) {  // mm, depth for the thread of a nut with a flat root of P/8
  return 5.0 / 16.0 * std::sqrt(3.0) * pitch;
}
inline double isoMetricNose(double pitch) {
  return std::sqrt(3.0) / 12.0 * pitch;
}

}  // namespace handwheel
