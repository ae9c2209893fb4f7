// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/CornerFit.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace handwheel {

namespace {

// Shoulders rise by more than this many steps within one; a flatter rise is a chamfer or an edge of an arc.
constexpr double kSteep = 3.0;

struct Span {
  double low, high;  // mm, z
  bool holds(double z, double slack) const { return z >= low - slack && z <= high + slack; }
};

Span spanOf(const ProfileSegment& step) {
  return {std::min(step.from.y(), step.to.y()), std::max(step.from.y(), step.to.y())};
}

// Returns the intersection of the lines or circles of two segments within a span of z, nearest to the step between
// them.
std::optional<ProfilePoint> corner(const ProfileSegment& before, const ProfileSegment& after,
                                   const ProfileSegment& step) {
  const Span span = spanOf(step);
  const double size = std::abs(step.to.y() - step.from.y());
  // Both are extended by the step, so that they overlap at their intersection.
  const auto longer = [&](const ProfileSegment& s, bool atEnd) {
    const double share = 1.0 + 4.0 * (step.to - step.from).norm() / std::max(s.length(), 1e-300);
    if (!s.isArc()) {
      const ProfilePoint along = (s.to - s.from) * share;
      return atEnd ? ProfileSegment{s.from, s.from + along, 0.0} : ProfileSegment{s.to - along, s.to, 0.0};
    }
    const double angle = std::clamp(s.angle() * share, -1.9 * M_PI, 1.9 * M_PI);
    const ProfilePoint c = s.centre();
    const ProfilePoint fixed = (atEnd ? s.from : s.to) - c;
    const double start = std::atan2(fixed.y(), fixed.x());
    return atEnd ? arcAround(c, s.radius(), start, start + angle) : arcAround(c, s.radius(), start - angle, start);
  };
  const auto found = meeting(longer(before, true), longer(after, false), 1e-9);
  if (!found || !span.holds(found->y(), 0.01 * size)) return std::nullopt;
  const double away = std::max((*found - step.from).norm(), (*found - step.to).norm());
  return away <= 4.0 * (step.to - step.from).norm() ? found : std::nullopt;
}

// Returns the height of a shoulder: that of an arc's tangent point beside it, or halfway.
double shoulderHeight(const ProfileSegment& before, const ProfileSegment& after, const ProfileSegment& step) {
  const Span span = spanOf(step);
  for (const ProfileSegment* s : {&before, &after}) {
    if (!s->isArc()) continue;
    for (const double side : {-1.0, 1.0}) {
      const double z = s->centre().y() + side * s->radius();
      if (span.holds(z, 1e-9)) return z;
    }
  }
  return 0.5 * (span.low + span.high);
}

// Returns the radius at a height on the line or circle of a segment, near that of a point.
double radiusAt(const ProfileSegment& segment, double z, const ProfilePoint& near) {
  if (!segment.isArc()) {
    const double rise = segment.to.y() - segment.from.y();
    const double t = rise != 0.0 ? (z - segment.from.y()) / rise : 0.0;
    return rise != 0.0 ? segment.from.x() + t * (segment.to.x() - segment.from.x()) : near.x();
  }
  const double up = z - segment.centre().y(), r = segment.radius();
  const double aside = std::sqrt(std::max(0.0, (r - up) * (r + up)));
  const double c = segment.centre().x();
  return std::abs(c + aside - near.x()) < std::abs(c - aside - near.x()) ? c + aside : c - aside;
}

bool isWithin(const ProfilePoint& p, std::initializer_list<ProfileSegment> some, double tolerance) {
  return std::any_of(some.begin(), some.end(),
                     [&](const ProfileSegment& s) { return (s.nearest(p) - p).norm() <= tolerance; });
}

}  // namespace

ProfileSegment endedAt(const ProfileSegment& segment, const ProfilePoint& end) {
  if (!segment.isArc()) return {segment.from, end, 0.0};
  const ProfilePoint c = segment.centre(), a = segment.from - c, b = end - c;
  double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  // The sense of rotation nearer to the former angle is used.
  for (const double other : {angle - 2.0 * M_PI, angle + 2.0 * M_PI})
    if (std::abs(other - segment.angle()) < std::abs(angle - segment.angle())) angle = other;
  return {segment.from, end, std::tan(0.25 * angle)};
}

ProfileSegment begunAt(const ProfileSegment& segment, const ProfilePoint& start) {
  return endedAt(segment.reversed(), start).reversed();
}

std::vector<ProfileSegment> sharpened(std::vector<ProfileSegment> segments, double spacing, double tolerance) {
  const auto isStep = [&](const ProfileSegment& s) {
    return !s.isArc() && std::abs(s.to.y() - s.from.y()) <= 1.001 * spacing;
  };
  std::vector<ProfileSegment> done;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const ProfileSegment step = segments[i];
    const bool isBetween = !done.empty() && i + 1 < segments.size();
    if (!isBetween || !isStep(step) || isStep(segments[i + 1]) || isStep(done.back())) {
      done.push_back(step);
      continue;
    }
    ProfileSegment &before = done.back(), &after = segments[i + 1];
    // Replaces the step by a wall from a to b, unless that is across the axis or leaves a sample beside the profile.
    const auto put = [&](const ProfilePoint& a, const ProfilePoint& b) {
      if (a.x() < 0.0 || b.x() < 0.0) return false;
      const ProfileSegment ended = endedAt(before, a), wall{a, b, 0.0}, begun = begunAt(after, b);
      if (!isWithin(step.from, {ended, wall, begun}, tolerance) || !isWithin(step.to, {ended, wall, begun}, tolerance))
        return false;
      before = ended;
      after = begun;
      if (a != b) done.push_back(wall);
      return true;
    };
    const auto sharp = corner(before, after, step);
    if (sharp && put(*sharp, *sharp)) continue;
    const double z = shoulderHeight(before, after, step);
    const bool isShoulder = std::abs(step.to.x() - step.from.x()) > kSteep * spacing;
    if (!isShoulder || !put({radiusAt(before, z, step.from), z}, {radiusAt(after, z, step.to), z}))
      done.push_back(step);
  }
  return done;
}

}  // namespace handwheel
