// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/BezierArc.h"

#include <Eigen/Geometry>
#include <optional>

namespace handwheel {

using ProfileBox = Eigen::AlignedBox2d;  // bounds of points (r, z); mm

// A straight line or circular arc of a profile, in the half plane (r, z).
//
// The arc is given as in DXF, by its ends and by its bulge, the tangent of a quarter of its angle. Lines are arcs of
// bulge 0, and flat arcs lose no digits. All functions are O(1).
struct ProfileSegment {
  ProfilePoint from{0, 0}, to{0, 0};  // mm
  double bulge = 0.0;                 // > 0: the arc turns from r towards z, counter-clockwise

  bool isArc() const { return bulge != 0.0; }
  double angle() const { return 4.0 * std::atan(bulge); }  // rad, with the sign of the bulge
  double radius() const;                                   // mm; infinite for a line
  ProfilePoint centre() const;                             // the segment must be an arc
  double length() const;                                   // mm

  // Returns the point at a fraction of the length, 0…1.
  ProfilePoint at(double t) const;
  ProfilePoint direction(double t) const;  // unit tangent; zero for a segment without length

  ProfilePoint nearest(const ProfilePoint& p) const;
  ProfileBox box() const;
  ProfileSegment reversed() const { return {to, from, -bulge}; }
  // Returns the piece between two fractions of the length, 0 ≤ a ≤ b ≤ 1.
  ProfileSegment piece(double a, double b) const;

  // Returns the integral of r² dz along the segment (mm³). π times the sum over a closed profile is the volume,
  // positive or negative.
  double squareMoment() const;

  bool operator==(const ProfileSegment&) const = default;
};

// Returns the arc from a through m to b, or a line if the points are collinear to rounding. Returns nothing if two of
// the points coincide.
std::optional<ProfileSegment> arcThrough(const ProfilePoint& a, const ProfilePoint& m, const ProfilePoint& b);

// Returns the arc around a centre from one angle to another (rad, counted from r towards z). The arc is
// counter-clockwise if the angles rise and clockwise if they fall. It must be less than a full circle.
ProfileSegment arcAround(const ProfilePoint& centre, double radius, double from, double to);

// Returns a point that two segments share, or nothing if they do not meet. slack: the largest distance (mm) at which
// they count as meeting.
std::optional<ProfilePoint> meeting(const ProfileSegment& a, const ProfileSegment& b, double slack);
// Returns a point, other than their common end, that two consecutive segments share. `next` begins at the end of
// `first`.
std::optional<ProfilePoint> meetingBeside(const ProfileSegment& first, const ProfileSegment& next, double slack);

}  // namespace handwheel
