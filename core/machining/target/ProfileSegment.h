// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/BezierArc.h"

#include <Eigen/Geometry>
#include <optional>

namespace handwheel {

using ProfileBox = Eigen::AlignedBox2d;  // of points (r, z); mm

// A straight line or circular arc of a profile, in the half plane (r, z).
//
// The arc is given as in DXF: by its ends and the tangent of a quarter of its angle. Lines are arcs of bulge 0, and
// flat arcs lose no digits. All functions O(1).
struct ProfileSegment {
  ProfilePoint from{0, 0}, to{0, 0};  // mm
  double bulge = 0.0;                 // > 0: the arc turns from r towards z, which is counter-clockwise

  bool isArc() const { return bulge != 0.0; }
  double angle() const { return 4.0 * std::atan(bulge); }  // rad, of the arc; signed as the bulge
  double radius() const;                                   // mm; infinite for a line
  ProfilePoint centre() const;                             // of an arc
  double length() const;                                   // mm

  // At a share of its length, 0…1.
  ProfilePoint at(double t) const;
  ProfilePoint direction(double t) const;  // unit tangent; zero for a segment without length

  ProfilePoint nearest(const ProfilePoint& p) const;
  ProfileBox box() const;
  ProfileSegment reversed() const { return {to, from, -bulge}; }
  // The piece between two shares of its length, 0 ≤ a ≤ b ≤ 1.
  ProfileSegment piece(double a, double b) const;

  // The integral of r² dz along it (mm³): π times the sum over a closed profile is the volume, of either sign.
  double squareMoment() const;

  bool operator==(const ProfileSegment&) const = default;
};

// The arc from a over m to b; a line where they are collinear to rounding. None where two of the points are one.
std::optional<ProfileSegment> arcThrough(const ProfilePoint& a, const ProfilePoint& m, const ProfilePoint& b);

// The arc around a centre between two angles (rad, from r towards z), of less than a full circle; it turns the way in
// which the angles grow or fall.
ProfileSegment arcAround(const ProfilePoint& centre, double radius, double from, double to);

// A point that two segments share. slack: mm, they count as meeting at this distance.
std::optional<ProfilePoint> meeting(const ProfileSegment& a, const ProfileSegment& b, double slack);
// The same for segments of which one begins where the other ends; what they share there does not count.
std::optional<ProfilePoint> meetingBeside(const ProfileSegment& first, const ProfileSegment& next, double slack);

}  // namespace handwheel
