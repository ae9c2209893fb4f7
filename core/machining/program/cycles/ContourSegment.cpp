// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/ContourSegment.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSameContourPoint = 1e-6;
constexpr double kBend = 1e-3;
constexpr PlanePoint kI(0.0, 1.0);

double across(const PlanePoint& a, const PlanePoint& b) {
  return (std::conj(a) * b).imag();
}

bool isOn(const ContourSegment& arc, const PlanePoint& p) {
  const double turn = arc.turn > 0 ? 1.0 : -1.0;
  return turn * across(arc.from - arc.centre, p - arc.centre) >= -kSameContourPoint &&
         turn * across(arc.to - arc.centre, p - arc.centre) <= kSameContourPoint;
}

// Returns the intersection of a line through `a` and `b` with an arc around `centre` to `end`: of the two points, the
// one nearer to `wanted`.
PlanePoint lineMeetsArc(const PlanePoint& a, const PlanePoint& b, const PlanePoint& centre, const PlanePoint& end,
                        const PlanePoint& wanted) {
  const PlanePoint turn = std::conj(a - b) / std::abs(a - b);
  const PlanePoint e = (end - b) * turn, c = (centre - b) * turn;
  const double half = std::sqrt(std::max(0.0, std::norm(c - e) - c.imag() * c.imag()));
  const PlanePoint first = (c.real() + half) / turn + b, second = (c.real() - half) / turn + b;
  return std::abs(wanted - first) < std::abs(wanted - second) ? first : second;
}

bool linesMeet(ContourSegment& a, ContourSegment& b) {
  const PlanePoint turn = std::conj(b.from - b.to) / std::abs(b.from - b.to);
  const PlanePoint s = (a.from - b.to) * turn, e = (a.to - b.to) * turn;
  if ((s - e).imag() == 0.0) return false;
  a.to = b.from = (s + s.imag() / (s - e).imag() * (e - s)) / turn + b.to;
  return true;
}

void arcsMeet(ContourSegment& a, ContourSegment& b) {
  const double r = b.radius(), s = a.radius(), d = std::abs(b.centre - a.centre);
  const double cosine = (d * d + r * r - s * s) / 2.0 / r / d;
  const PlanePoint turn(cosine, std::sqrt(1.0 - std::min(1.0, cosine * cosine)));
  const PlanePoint meetingPoint = turn * (a.centre - b.centre) / d * r + b.centre;
  if (std::isfinite(meetingPoint.real()) && std::isfinite(meetingPoint.imag())) a.to = b.from = meetingPoint;
}

}  // namespace

double ContourSegment::size() const {
  const double length = std::abs(from - to);
  return turn == 0 ? length : std::min(length, radius());
}

bool ContourSegment::isMonotonic() const {
  const double along = (to - from).real();
  if (turn == 0) return along <= kBend;
  if (corner != 0.0) return true;
  const double begin = turn * (from - centre).imag(), end = turn * (to - centre).imag();
  return begin >= -kBend && end >= -kBend && along <= -kBend;
}

void ContourSegment::move(const PlanePoint& by) {
  from += by;
  to += by;
  centre += by;
}

void ContourSegment::offset(double distance) {
  if (turn == 0) {
    const PlanePoint by = kI * distance * (from - to) / std::abs(from - to);
    from += by;
    to += by;
    return;
  }
  const double factor = (radius() + turn * distance) / radius();
  from = factor * (from - centre) + centre;
  to = factor * (to - centre) + centre;
}

void ContourSegment::mirrorRadius() {
  turn = -turn;
  from = std::conj(from);
  to = std::conj(to);
  centre = std::conj(centre);
}

void ContourSegment::mirrorLength() {
  turn = -turn;
  from = -std::conj(from);
  to = -std::conj(to);
  centre = -std::conj(centre);
}

void ContourSegment::turnQuarter() {
  from *= -kI;
  to *= -kI;
  centre *= -kI;
}

std::vector<double> ContourSegment::crossings(double r) const {
  if (turn == 0) {
    if (std::min(from.imag(), to.imag()) > r + kSameContourPoint ||
        std::max(from.imag(), to.imag()) < r - kSameContourPoint)
      return {};
    if (std::abs((from - to).imag()) < kSameContourPoint) return {from.real(), to.real()};
    return {(r - from.imag()) / (to.imag() - from.imag()) * (to.real() - from.real()) + from.real()};
  }
  const double height = r - centre.imag();
  const double square = radius() * radius() - height * height;
  if (square < -kSameContourPoint) return {};
  const double half = std::sqrt(std::max(0.0, square));
  std::vector<double> found;
  for (const double z : {centre.real() + half, centre.real() - half})
    if (isOn(*this, {z, r})) found.push_back(z);
  return found;
}

bool meet(ContourSegment& a, ContourSegment& b) {
  if (a.turn == 0 && b.turn == 0) return linesMeet(a, b);
  if (a.turn != 0 && b.turn != 0) {
    arcsMeet(a, b);
    return true;
  }
  if (std::abs(b.from - a.to) < kSameContourPoint) return true;
  a.to = b.from = a.turn != 0 ? lineMeetsArc(b.from, b.to, a.centre, a.to, b.from)
                              : lineMeetsArc(a.from, a.to, b.centre, b.to, b.from);
  return true;
}

}  // namespace handwheel
