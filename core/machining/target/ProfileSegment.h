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
// The arc is given as in DXF: by its ends and the tangent of a quarter of its angle. Lines are arcs of bulge 0, and
// flat arcs lose no digits. All functions O(1).
struct ProfileSegment {
  ProfilePoint from{0, 0}, to{0, 0};  // mm
  double bulge = 0.0;                 // > 0: the arc turns from r towards z, that is counter-clockwise

  bool isArc() const { return bulge != 0.0; }
  double angle() const { return 4.0 * std::atan(bulge); }  // rad; signed like the bulge
  double radius() const;                                   // mm; infinite for a line
  ProfilePoint centre() const;                             // for an arc only
  double length() const;                                   // mm

  // Returns the point at a share of the length, 0…1.
  ProfilePoint at(double t) const;
  ProfilePoint direction(double t) const;  // unit tangent; zero for a segment without length

  ProfilePoint nearest(const ProfilePoint& p) const;
  ProfileBox box() const;
  ProfileSegment reversed() const { return {to, from, -bulge}; }
  // Returns the piece between two shares of the length, 0 ≤ a ≤ b ≤ 1.
  ProfileSegment piece(double a, double b) const;

  // Returns the integral of r² dz along it (mm³): π times the sum over a closed profile is the volume, of either sign.
  double squareMoment() const;

  bool operator==(const ProfileSegment&) const = default;
};

// Returns the arc from a over m to b; a line if they are collinear to rounding. Returns nothing if two of the points
// coincide.
std::optional<ProfileSegment> arcThrough(const ProfilePoint& a, const ProfilePoint& m, const ProfilePoint& b);

// Returns the arc around a centre between two angles (rad, from r towards z), of less than a full circle; it turns in
// the direction in which the angles grow or fall.
ProfileSegment arcAround(const ProfilePoint& centre, double radius, double from, double to);

// Returns a point that two segments share. slack: mm, they count as meeting at this distance.
std::optional<ProfilePoint> meeting(const ProfileSegment& a, const ProfileSegment& b, double slack);
// The same for two segments of which one begins at the end of the other; their shared end does not count.
std::optional<ProfilePoint> meetingBeside(const ProfileSegment& first, const ProfileSegment& next, double slack);

}  // namespace handwheel
