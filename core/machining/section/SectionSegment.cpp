// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/SectionSegment.h"

#include "machining/section/PlaneVectors.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

void addLines(const SectionCarrier& a, const SectionCarrier& b, CarrierMeetings& found) {
  const double sine = crossProduct(a.along, b.along);
  constexpr double kParallel = 1e-12;
  if (std::abs(sine) > kParallel)
    found.points[found.count++] = a.point + crossProduct(b.point - a.point, b.along) / sine * a.along;
}

// Adds the points of a chord with this middle and direction. square: the square of its half length. isTouching: the
// curves overlap or miss each other by no more than the slack, so that rounding decides on the length of the chord.
void addChord(const ProfilePoint& middle, const ProfilePoint& along, double square, bool isTouching,
              CarrierMeetings& found) {
  if (isTouching || square <= 0.0) {
    found.points[found.count++] = middle;
    return;
  }
  const double half = std::sqrt(square);
  found.points[found.count++] = middle - half * along;
  found.points[found.count++] = middle + half * along;
}

void addLineCircle(const SectionCarrier& line, const SectionCarrier& circle, double slack, CarrierMeetings& found) {
  const ProfilePoint middle = line.point + (circle.point - line.point).dot(line.along) * line.along;
  const double off = (middle - circle.point).norm(), radius = std::abs(circle.radius);
  if (off <= radius + slack)
    addChord(middle, line.along, (radius - off) * (radius + off), std::abs(radius - off) <= slack, found);
}

void addCircles(const SectionCarrier& a, const SectionCarrier& b, double slack, CarrierMeetings& found) {
  const ProfilePoint between = b.point - a.point;
  const double distance = between.norm(), ra = std::abs(a.radius), rb = std::abs(b.radius);
  if (!(distance > slack) || distance > ra + rb + slack || distance < std::abs(ra - rb) - slack) return;
  const double foot = 0.5 * (distance + (ra - rb) * (ra + rb) / distance);
  const ProfilePoint along = between / distance;
  const bool isTouching = ra + rb - distance <= slack || distance - std::abs(ra - rb) <= slack;
  addChord(a.point + foot * along, turnedLeft(along), (ra - foot) * (ra + foot), isTouching, found);
}

}  // namespace

double SectionCarrier::distance(const ProfilePoint& p) const {
  return isCircle() ? std::abs((p - point).norm() - std::abs(radius)) : std::abs(crossProduct(along, p - point));
}

ProfilePoint SectionCarrier::direction(const ProfilePoint& p) const {
  if (!isCircle()) return along;
  const ProfilePoint tangent = turnedLeft(p - point).normalized();
  return radius > 0.0 ? tangent : ProfilePoint(-tangent);
}

CarrierMeetings meetings(const SectionCarrier& a, const SectionCarrier& b, double slack) {
  CarrierMeetings found;
  if (a.isCircle() && b.isCircle())
    addCircles(a, b, slack, found);
  else if (a.isCircle() || b.isCircle())
    addLineCircle(a.isCircle() ? b : a, a.isCircle() ? a : b, slack, found);
  else
    addLines(a, b, found);
  return found;
}

SectionSegment SectionSegment::line(const ProfilePoint& from, const ProfilePoint& to) {
  SectionSegment segment;
  segment.carrier.point = from;
  const double length = (to - from).norm();
  if (length > 0.0) segment.carrier.along = (to - from) / length;
  segment.from = from;
  segment.to = to;
  return segment;
}

SectionSegment SectionSegment::arc(const ProfilePoint& centre, const ProfilePoint& from, const ProfilePoint& to,
                                   int turn) {
  SectionSegment segment;
  segment.carrier.point = centre;
  segment.carrier.radius = turn * 0.5 * ((from - centre).norm() + (to - centre).norm());
  segment.from = from;
  segment.to = to;
  return segment;
}

SectionSegment SectionSegment::of(const ProfileSegment& curve) {
  // An arc that rises less than two points are apart is a line.
  constexpr double kFlat = 2e-8;  // mm
  const double rise = 0.5 * std::abs(curve.bulge) * (curve.to - curve.from).norm();
  if (!std::isfinite(curve.radius()) || rise < kFlat) return line(curve.from, curve.to);
  SectionSegment segment = arc(curve.centre(), curve.from, curve.to, curve.bulge > 0.0 ? 1 : -1);
  segment.carrier.radius = std::copysign(curve.radius(), curve.bulge);
  return segment;
}

double SectionSegment::lengthTo(const ProfilePoint& p) const {
  if (!carrier.isCircle()) return (p - from).dot(carrier.along);
  const ProfilePoint a = from - carrier.point, b = p - carrier.point;
  const double radius = std::abs(carrier.radius), turn = carrier.radius > 0.0 ? 1.0 : -1.0;
  double angle = turn * std::atan2(crossProduct(a, b), a.dot(b));
  constexpr double kBeforeStart = 1e-6;  // mm
  if (angle * radius < -kBeforeStart) angle += 2.0 * M_PI;
  return angle * radius;
}

double SectionSegment::length() const {
  return carrier.isCircle() ? std::max(0.0, lengthTo(to)) : (to - from).norm();
}

ProfilePoint SectionSegment::at(double length) const {
  if (!carrier.isCircle()) return from + length * carrier.along;
  const double angle = length / carrier.radius, c = std::cos(angle), s = std::sin(angle);
  const ProfilePoint a = from - carrier.point;
  return carrier.point + ProfilePoint(c * a.x() - s * a.y(), s * a.x() + c * a.y());
}

ProfilePoint SectionSegment::nearest(const ProfilePoint& p) const {
  const double whole = length(), here = lengthTo(p);
  if (!carrier.isCircle()) return here <= 0.0 ? from : here >= whole ? to : ProfilePoint(at(here));
  const ProfilePoint outward = p - carrier.point;
  const double distance = outward.norm();
  if (here >= 0.0 && here <= whole && distance > 0.0)
    return carrier.point + std::abs(carrier.radius) / distance * outward;
  return (p - from).squaredNorm() <= (p - to).squaredNorm() ? from : to;
}

bool SectionSegment::isOn(const ProfilePoint& p, double slack) const {
  if ((p - from).squaredNorm() <= slack * slack || (p - to).squaredNorm() <= slack * slack) return true;
  if (carrier.distance(p) > slack) return false;
  const double here = lengthTo(p);
  return here > 0.0 && here < length();
}

ProfileBox SectionSegment::box() const {
  ProfileBox box(from);
  box.extend(to);
  if (!carrier.isCircle()) return box;
  const double radius = std::abs(carrier.radius), whole = length();
  for (const ProfilePoint& out : {ProfilePoint(1, 0), ProfilePoint(0, 1), ProfilePoint(-1, 0), ProfilePoint(0, -1)}) {
    const ProfilePoint extreme = carrier.point + radius * out;
    const double here = lengthTo(extreme);
    if (here > 0.0 && here < whole) box.extend(extreme);
  }
  return box;
}

// An arc of less than half a circle is within half of its chord from that; any arc is within its circle.
ProfileBox SectionSegment::looseBox() const {
  ProfileBox box(from);
  box.extend(to);
  if (!carrier.isCircle()) return box;
  const double turn = carrier.radius > 0.0 ? 1.0 : -1.0;
  const bool isMinor = turn * crossProduct(from - carrier.point, to - carrier.point) > 0.0;
  if (!isMinor) {
    const ProfilePoint out = ProfilePoint::Constant(std::abs(carrier.radius));
    box.extend(ProfilePoint(carrier.point - out));
    box.extend(ProfilePoint(carrier.point + out));
    return box;
  }
  const ProfilePoint out = ProfilePoint::Constant(0.5 * (to - from).norm());
  return ProfileBox(box.min() - out, box.max() + out);
}

ProfileSegment SectionSegment::curve() const {
  if (!carrier.isCircle()) return {from, to, 0.0};
  return {from, to, std::tan(0.25 * length() / carrier.radius)};
}

double SectionSegment::moment() const {
  const double chord = 0.5 * (from.x() + to.x()) * (to.y() - from.y());
  if (!carrier.isCircle()) return chord;
  // The area between an arc and its chord; the series avoids the cancellation of short arcs.
  const double angle = length() / carrier.radius, square = carrier.radius * carrier.radius;
  constexpr double kShort = 1e-3;  // rad
  const double rest = std::abs(angle) < kShort ? angle * angle * angle / 6.0 : angle - std::sin(angle);
  return chord + 0.5 * square * rest;
}

double areaOf(std::span<const SectionSegment> loop) {
  double sum = 0.0;
  for (const SectionSegment& segment : loop) sum += segment.moment();
  return sum;
}

double volumeOf(std::span<const SectionSegment> loop) {
  double sum = 0.0;
  for (const SectionSegment& segment : loop) sum += segment.squareMoment();
  return M_PI * sum;
}

ProfileBox boxOf(std::span<const SectionSegment> loop) {
  ProfileBox box;
  for (const SectionSegment& segment : loop)
    if (!box.contains(segment.looseBox())) box.extend(segment.box());
  return box;
}

}  // namespace handwheel
