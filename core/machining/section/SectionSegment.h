// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/ProfileSegment.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace handwheel {

// The line or circle that a piece of a section lies on.
//
// A piece keeps its carrier when a cut shortens it. A dimension that was programmed is therefore read from the carrier
// and stays exact however often, and however short, the piece is cut.
struct SectionCarrier {
  ProfilePoint point{0, 0};  // a point of the line, or the centre of the circle; mm
  ProfilePoint along{0, 1};  // unit direction of a line
  double radius = 0.0;       // mm; 0: a line; > 0: a circle, counter-clockwise with r to the right; < 0: clockwise

  bool isCircle() const { return radius != 0.0; }
  SectionCarrier reversed() const { return {point, -along, -radius}; }
  double distance(const ProfilePoint& p) const;         // mm, not signed
  ProfilePoint direction(const ProfilePoint& p) const;  // unit tangent at a point of the carrier
};

// Returns the points at which two carriers meet. Carriers that touch within `slack` (mm) meet at the point of contact;
// parallel lines and concentric circles do not meet.
struct CarrierMeetings {
  std::array<ProfilePoint, 2> points;
  std::size_t count = 0;
};
CarrierMeetings meetings(const SectionCarrier& a, const SectionCarrier& b, double slack);

// A piece of the boundary of a section, a line or an arc. An arc is less than a full circle.
struct SectionSegment {
  static constexpr std::uint32_t kBar = 0xffff'ffff;

  SectionCarrier carrier;
  ProfilePoint from{0, 0}, to{0, 0};  // mm
  std::uint32_t pass = kBar;          // index in the part of the pass that made the piece; kBar: none did
  // The trailing edge of a bare nose has made the piece while it faced (cutMove()).
  bool isOfTrailingEdge = false;

  static SectionSegment line(const ProfilePoint& from, const ProfilePoint& to);
  // turn: 1 for an arc that runs counter-clockwise with r to the right and z up, -1 for a clockwise one.
  static SectionSegment arc(const ProfilePoint& centre, const ProfilePoint& from, const ProfilePoint& to, int turn);
  static SectionSegment of(const ProfileSegment& curve);

  double length() const;  // mm
  // Returns the length from the start to the foot of a point on the carrier. It is negative for a point before the
  // start of a line, and for a point just before the start of an arc.
  double lengthTo(const ProfilePoint& p) const;
  ProfilePoint at(double length) const;
  ProfilePoint nearest(const ProfilePoint& p) const;
  bool isOn(const ProfilePoint& p, double slack) const;
  ProfileBox box() const;
  // Returns a box that is at least as large, in less time.
  ProfileBox looseBox() const;
  SectionSegment reversed() const { return {carrier.reversed(), to, from, pass, isOfTrailingEdge}; }
  ProfileSegment curve() const;

  // Return the integrals of r dz and r² dz along the segment, mm² and mm³.
  double moment() const;
  double squareMoment() const { return curve().squareMoment(); }
};

using SectionLoop = std::vector<SectionSegment>;  // closed; each segment begins at the end of the one before

double areaOf(std::span<const SectionSegment> loop);    // mm²; positive for a counter-clockwise loop
double volumeOf(std::span<const SectionSegment> loop);  // mm³, volume of revolution with the sign of the area
ProfileBox boxOf(std::span<const SectionSegment> loop);

}  // namespace handwheel
