// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/CurveFit.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

using Points = std::span<const ProfilePoint>;

constexpr double kMostArc = 1.9 * M_PI;  // rad

// Returns true if all points of a range are on the segment, in its order, to the tolerance.
bool isAlong(const ProfileSegment& segment, Points points, double tolerance) {
  double last = 0.0;
  const ProfilePoint centre = segment.isArc() ? segment.centre() : segment.from;
  const ProfilePoint along = (segment.to - segment.from).normalized();
  const double turn = segment.bulge > 0.0 ? 1.0 : -1.0;
  const ProfilePoint start = segment.from - centre;
  for (const ProfilePoint& p : points) {
    if ((segment.nearest(p) - p).norm() > tolerance) return false;
    // It must not go back by more than the tolerance, nor turn round at a corner.
    double travel = (p - segment.from).dot(along);
    if (segment.isArc()) {
      const ProfilePoint v = p - centre;
      double swept = turn * std::atan2(start.x() * v.y() - start.y() * v.x(), start.dot(v));
      if (swept < -0.01 * M_PI) swept += 2.0 * M_PI;
      travel = swept * segment.radius();
    }
    if (travel < last - 2.0 * tolerance) return false;
    last = std::max(last, travel);
  }
  return true;
}

std::optional<ProfileSegment> lineOver(Points points, double tolerance) {
  const ProfileSegment line{points.front(), points.back(), 0.0};
  return isAlong(line, points, tolerance) ? std::optional<ProfileSegment>(line) : std::nullopt;
}

// Returns the arc through the ends and the point that is furthest from their chord.
std::optional<ProfileSegment> arcOver(Points points, double tolerance) {
  if (points.size() < 3) return std::nullopt;
  const ProfilePoint chord = points.back() - points.front();
  const auto rise = [&](const ProfilePoint& p) {
    const ProfilePoint v = p - points.front();
    return chord.norm() > 0.0 ? std::abs(chord.x() * v.y() - chord.y() * v.x()) : v.norm();
  };
  const auto top = std::max_element(points.begin(), points.end(),
                                    [&](const ProfilePoint& a, const ProfilePoint& b) { return rise(a) < rise(b); });
  const auto arc = arcThrough(points.front(), *top, points.back());
  if (!arc || !arc->isArc() || std::abs(arc->angle()) > kMostArc) return std::nullopt;
  return isAlong(*arc, points, tolerance) ? arc : std::nullopt;
}

// Returns the furthest point to which a segment from `from` fits: doubling, then halving the step.
template <class Fit>
std::size_t reach(std::size_t from, std::size_t size, const Fit& fits) {
  std::size_t step = 1;
  while (from + 2 * step < size && fits(from + 2 * step)) step *= 2;
  std::size_t to = from + step;
  for (std::size_t half = step; half > 0; half /= 2) {
    if (to + half < size && fits(to + half)) to += half;
  }
  return to;
}

std::size_t samplesFor(const ParametricCurve& curve, double tolerance) {
  constexpr std::size_t kLeast = 32, kMost = 8192;
  // The rise of an arc over its chord falls with the square of the number of chords; arcs need far fewer.
  double rise = 0.0;
  for (std::size_t i = 0; i < kLeast; ++i) {
    const auto at = [&](double k) { return curve((static_cast<double>(i) + k) / kLeast); };
    rise = std::max(rise, (at(0.5) - 0.5 * (at(0.0) + at(1.0))).norm());
  }
  if (!(rise > tolerance)) return 2 * kLeast;
  const double count = kLeast * 4.0 * std::sqrt(rise / tolerance);
  return static_cast<std::size_t>(std::clamp<double>(count, 2.0 * kLeast, kMost));
}

}  // namespace

std::vector<ProfileSegment> fitSegments(std::span<const ProfilePoint> points, double tolerance) {
  std::vector<ProfileSegment> segments;
  for (std::size_t at = 0; at + 1 < points.size();) {
    const auto range = [&](std::size_t to) { return points.subspan(at, to - at + 1); };
    const std::size_t byLine =
        reach(at, points.size(), [&](std::size_t to) { return lineOver(range(to), tolerance).has_value(); });
    const std::size_t byArc =
        reach(at, points.size(), [&](std::size_t to) { return arcOver(range(to), tolerance).has_value(); });
    // Four points always lie near some arc: more points are needed.
    const bool isArc = byArc > byLine && byArc >= at + 4 && arcOver(range(byArc), tolerance);
    const std::size_t next = isArc ? byArc : byLine;
    const ProfileSegment line{points[at], points[next], 0.0};
    segments.push_back(isArc ? *arcOver(range(next), tolerance) : line);
    at = next;
  }
  return segments;
}

std::vector<ProfileSegment> fitSegments(const ParametricCurve& curve, double tolerance) {
  const std::size_t count = samplesFor(curve, tolerance);
  std::vector<ProfilePoint> points(count + 1);
  for (std::size_t i = 0; i <= count; ++i) points[i] = curve(static_cast<double>(i) / static_cast<double>(count));
  return fitSegments(points, tolerance);
}

}  // namespace handwheel
