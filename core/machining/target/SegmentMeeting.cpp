// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileSegment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

double wedge(const ProfilePoint& a, const ProfilePoint& b) {
  return a.x() * b.y() - a.y() * b.x();
}

bool isOn(const ProfileSegment& segment, const ProfilePoint& p, double slack) {
  return (segment.nearest(p) - p).norm() <= slack;
}

// At most two intersections of the curves, and the ends of both.
struct Candidates {
  std::array<ProfilePoint, 6> points;
  std::size_t count = 0;
  void add(const ProfilePoint& p) { points[count++] = p; }
  const ProfilePoint* begin() const { return points.data(); }
  const ProfilePoint* end() const { return points.data() + count; }
};

// The supporting line or circle of a segment.
struct Support {
  explicit Support(const ProfileSegment& segment) : isCircle(std::isfinite(segment.radius())) {
    point = isCircle ? segment.centre() : segment.from;
    radius = isCircle ? segment.radius() : 0.0;
    if (!isCircle) along = (segment.to - segment.from).normalized();
  }
  bool isCircle;
  ProfilePoint point{0, 0}, along{0, 0};
  double radius;
};

void addLines(const Support& a, const Support& b, Candidates& found) {
  const double sine = wedge(a.along, b.along);
  if (std::abs(sine) > 1e-12) found.add(a.point + wedge(b.point - a.point, b.along) / sine * a.along);
}

void addLineCircle(const Support& line, const Support& circle, Candidates& found) {
  const double foot = (circle.point - line.point).dot(line.along);
  const ProfilePoint middle = line.point + foot * line.along;
  const double off = (middle - circle.point).norm();
  const double half = std::sqrt(std::max(0.0, (circle.radius - off) * (circle.radius + off)));
  found.add(middle - half * line.along);
  found.add(middle + half * line.along);
}

void addCircles(const Support& a, const Support& b, Candidates& found) {
  const ProfilePoint between = b.point - a.point;
  const double distance = between.norm();
  if (!(distance > 1e-12 * (a.radius + b.radius))) return;  // concentric: only the ends decide
  const double foot = 0.5 * (distance + (a.radius - b.radius) * (a.radius + b.radius) / distance);
  const double half = std::sqrt(std::max(0.0, (a.radius - foot) * (a.radius + foot)));
  const ProfilePoint along = between / distance, across(-along.y(), along.x());
  found.add(a.point + foot * along - half * across);
  found.add(a.point + foot * along + half * across);
}

// Returns the intersections of the curves behind two segments, and the ends of both, which reveal overlaps.
Candidates candidates(const ProfileSegment& a, const ProfileSegment& b) {
  Candidates found;
  const Support s(a), t(b);
  if (s.isCircle && t.isCircle) {
    addCircles(s, t, found);
  } else if (s.isCircle || t.isCircle) {
    addLineCircle(s.isCircle ? t : s, s.isCircle ? s : t, found);
  } else {
    addLines(s, t, found);
  }
  for (const ProfilePoint& end : {a.from, a.to, b.from, b.to}) found.add(end);
  return found;
}

}  // namespace

std::optional<ProfilePoint> meeting(const ProfileSegment& a, const ProfileSegment& b, double slack) {
  for (const ProfilePoint& p : candidates(a, b)) {
    if (isOn(a, p, slack) && isOn(b, p, slack)) return p;
  }
  return std::nullopt;
}

std::optional<ProfilePoint> meetingBeside(const ProfileSegment& first, const ProfileSegment& next, double slack) {
  // Curves that separate with nearly one tangent stay within the slack of one another for about its root.
  const double apart = std::max({first.length(), next.length(), 1.0});
  const double near = std::max(10.0 * slack, 4.0 * std::sqrt(slack * apart));
  const ProfilePoint shared = first.to;
  for (const ProfilePoint& p : candidates(first, next)) {
    const bool isNear = (p - shared).norm() <= near;
    if (!isNear && isOn(first, p, slack) && isOn(next, p, slack)) return p;
  }
  // The next segment turns back along the first.
  const double ahead = std::min({near * 2.0, first.length(), next.length()});
  if (!(ahead > 0.0)) return std::nullopt;
  const ProfilePoint back = first.at(1.0 - ahead / first.length());
  const ProfilePoint on = next.at(ahead / next.length());
  return (back - on).norm() <= slack ? std::optional<ProfilePoint>(shared) : std::nullopt;
}

}  // namespace handwheel
