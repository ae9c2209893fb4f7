// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/CornerPiece.h"

#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr PlanePoint kQuarter(0.0, 1.0);  // turns by a quarter, counter-clockwise
constexpr double kSmoothJoint = 1e-9;     // sine of the angle below which there is no corner
constexpr double kPastCorner = 1e-9;      // by which a piece may reach over the end of a segment

double cross(const PlanePoint& a, const PlanePoint& b) {
  return (std::conj(a) * b).imag();
}

double dot(const PlanePoint& a, const PlanePoint& b) {
  return (std::conj(a) * b).real();
}

PlanePoint unitOf(const PlanePoint& p) {
  return p / std::abs(p);
}

PlanePoint directionAt(const ContourSegment& segment, const PlanePoint& p) {
  if (segment.turn == 0) return unitOf(segment.to - segment.from);
  return kQuarter * static_cast<double>(segment.turn) * unitOf(p - segment.centre);
}

// Returns the angle from one point of an arc to another in its direction, from 0 to 2π.
double sweepTo(const ContourSegment& arc, const PlanePoint& from, const PlanePoint& to) {
  const double angle = arc.turn * std::arg((to - arc.centre) / (from - arc.centre));
  return angle < -kPastCorner ? angle + 2.0 * M_PI : angle;
}

bool contains(const ContourSegment& segment, const PlanePoint& p) {
  if (segment.turn == 0) {
    const PlanePoint along = segment.to - segment.from;
    const double at = dot(along, p - segment.from) / std::norm(along);
    return at >= -kPastCorner && at <= 1.0 + kPastCorner;
  }
  return sweepTo(segment, segment.from, p) <= sweepTo(segment, segment.from, segment.to) + kPastCorner;
}

// The line or circle of the centres from which a rounding touches a segment.
struct Parallel {
  PlanePoint point, direction;  // a point of the line and its direction; for a circle, its centre and 0
  double radius = 0.0;          // 0: a line
};

// side: 1 for the left side of the segment, -1 for the right.
Parallel parallelTo(const ContourSegment& segment, double distance, double side) {
  if (segment.turn != 0) return {segment.centre, {}, segment.radius() - side * segment.turn * distance};
  const PlanePoint direction = unitOf(segment.to - segment.from);
  return {segment.from + kQuarter * direction * side * distance, direction, 0.0};
}

std::vector<PlanePoint> meetingPoints(const Parallel& a, const Parallel& b) {
  if (a.radius == 0.0 && b.radius == 0.0) {
    const double sine = cross(a.direction, b.direction);
    return {a.point + a.direction * (cross(b.point - a.point, b.direction) / sine)};
  }
  if (a.radius != 0.0 && b.radius == 0.0) return meetingPoints(b, a);
  PlanePoint foot, across;  // the middle between both points, and the unit vector to one of them
  double height = 0.0;      // distance of the middle from the centre of b
  if (a.radius == 0.0) {
    foot = a.point + a.direction * dot(a.direction, b.point - a.point);
    across = a.direction;
    height = std::abs(foot - b.point);
  } else {
    const double gap = std::abs(a.point - b.point);
    if (!(gap > 0.0)) return {};
    height = (b.radius * b.radius - a.radius * a.radius + gap * gap) / (2.0 * gap);
    foot = b.point + height * unitOf(a.point - b.point);
    across = kQuarter * unitOf(a.point - b.point);
  }
  const double square = b.radius * b.radius - height * height;
  if (square < 0.0) return {};
  return {foot + std::sqrt(square) * across, foot - std::sqrt(square) * across};
}

PlanePoint touchingPoint(const ContourSegment& segment, const PlanePoint& centre) {
  if (segment.turn != 0) return segment.centre + segment.radius() * unitOf(centre - segment.centre);
  const PlanePoint direction = unitOf(segment.to - segment.from);
  return segment.from + direction * dot(direction, centre - segment.from);
}

std::optional<ContourSegment> roundingOf(const ContourSegment& before, const ContourSegment& after, double radius,
                                         double side) {
  const Parallel a = parallelTo(before, radius, side), b = parallelTo(after, radius, side);
  if (a.radius < 0.0 || b.radius < 0.0) return {};
  std::optional<ContourSegment> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (const PlanePoint& centre : meetingPoints(a, b)) {
    ContourSegment piece;
    piece.turn = side > 0.0 ? 1 : -1;
    piece.centre = centre;
    piece.from = touchingPoint(before, centre);
    piece.to = touchingPoint(after, centre);
    const double distance = std::abs(centre - after.from);
    if (!(distance < nearest) || !contains(before, piece.from) || !contains(after, piece.to)) continue;
    nearest = distance;
    best = piece;
  }
  return best;
}

// Returns the point of a segment with this straight distance from its end, or from its beginning.
std::optional<PlanePoint> pointBeside(const ContourSegment& segment, double distance, bool isEnd) {
  const PlanePoint corner = isEnd ? segment.to : segment.from;
  const double back = isEnd ? -1.0 : 1.0;
  if (segment.turn == 0) {
    if (distance > std::abs(segment.to - segment.from) + kPastCorner) return {};
    return corner + back * distance * directionAt(segment, corner);
  }
  const double sine = distance / (2.0 * segment.radius());
  if (!(sine <= 1.0)) return {};
  const double angle = 2.0 * std::asin(sine);
  if (angle > sweepTo(segment, segment.from, segment.to) + kPastCorner) return {};
  return segment.centre + (corner - segment.centre) * std::polar(1.0, back * segment.turn * angle);
}

}  // namespace

std::optional<ContourSegment> cornerPiece(ContourSegment& before, ContourSegment& after, const CornerSize& corner) {
  const double sine = cross(directionAt(before, before.to), directionAt(after, after.from));
  if (!(std::abs(sine) > kSmoothJoint) || !(corner.size > 0.0)) return {};
  std::optional<ContourSegment> piece;
  if (corner.isRound) {
    piece = roundingOf(before, after, corner.size, sine > 0.0 ? 1.0 : -1.0);
  } else {
    const std::optional<PlanePoint> from = pointBeside(before, corner.size, true),
                                    to = pointBeside(after, corner.size, false);
    if (from && to) {
      piece.emplace();
      piece->from = *from;
      piece->to = *to;
    }
  }
  if (!piece) return {};
  before.to = piece->from;
  after.from = piece->to;
  return piece;
}

}  // namespace handwheel
