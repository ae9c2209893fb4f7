// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/section/ToolSweep.h"

#include "machining/section/PlaneVectors.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using Corners = std::vector<ProfilePoint>;

// Removes the corners of a convex polygon that are between their neighbours and within 1e-10 mm of the line through
// them.
void removeFlatCorners(Corners& hull) {
  constexpr double kFlat = 1e-10;  // mm
  for (std::size_t i = 0; i < hull.size() && hull.size() > 2;) {
    const ProfilePoint &before = hull[(i + hull.size() - 1) % hull.size()], &next = hull[(i + 1) % hull.size()];
    const ProfilePoint here = hull[i] - before, onward = next - hull[i];
    if (here.dot(onward) > 0.0 && crossProduct(here, onward) <= kFlat * (next - before).norm())
      hull.erase(hull.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
}

// Returns the convex hull, counter-clockwise with r to the right (Andrew 1979), without flat corners. Flat corners are
// removed at the end: while the hull grows, points whose r differ by rounding come in any order along a wall.
Corners hullOf(Corners points) {
  std::sort(points.begin(), points.end(), [](const ProfilePoint& a, const ProfilePoint& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  constexpr double kSame = 1e-10;  // mm
  Corners apart;
  for (const ProfilePoint& p : points) {
    if (std::none_of(apart.begin(), apart.end(), [&](const ProfilePoint& q) { return (p - q).norm() <= kSame; }))
      apart.push_back(p);
  }
  if (apart.size() < 3) return apart;
  Corners hull;
  const auto add = [&](const ProfilePoint& p, std::size_t floor) {
    while (hull.size() >= floor + 2 && crossProduct(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const ProfilePoint& p : apart) add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t i = apart.size() - 1; i-- > 0;) add(apart[i], lower);
  hull.pop_back();
  removeFlatCorners(hull);
  return hull;
}

// Returns the loop of a hull whose edges are moved outward. Corners sharper than 90° are cut off near that distance.
SectionLoop sharpLoop(const Corners& hull, double grown) {
  if (hull.size() < 3) return {};
  Corners corners;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const ProfilePoint &before = hull[(i + hull.size() - 1) % hull.size()], &next = hull[(i + 1) % hull.size()];
    const ProfilePoint arriving = (hull[i] - before).normalized(), leaving = (next - hull[i]).normalized();
    const ProfilePoint m = -turnedLeft(arriving), n = -turnedLeft(leaving);
    if (m.dot(n) >= 0.0 || grown == 0.0) {
      corners.push_back(hull[i] + grown / std::max(1.0, 1.0 + m.dot(n)) * (m + n));
    } else {
      // Shares with which both coordinates of a corner of 30°, 45° or 60° change.
      constexpr double kPast = 0.73, kAhead = 0.47;
      corners.push_back(hull[i] + grown * (m + kPast * arriving));
      corners.push_back(hull[i] + grown * (n - kAhead * leaving));
    }
  }
  SectionLoop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
    loop.push_back(SectionSegment::line(corners[i], corners[(i + 1) % corners.size()]));
  return loop;
}

SectionLoop disc(const ProfilePoint& centre, double radius) {
  const ProfilePoint right = centre + ProfilePoint(radius, 0), left = centre - ProfilePoint(radius, 0);
  return {SectionSegment::arc(centre, right, left, 1), SectionSegment::arc(centre, left, right, 1)};
}

// Returns the boundary of a hull that is offset by a radius.
SectionLoop hullLoop(const Corners& points, double radius, double grown) {
  const Corners hull = hullOf(points);
  if (hull.empty()) return {};
  if (!(radius > 0.0)) return sharpLoop(hull, grown);
  const double r = radius + grown;
  if (hull.size() == 1) return disc(hull[0], r);
  SectionLoop loop;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const ProfilePoint &p = hull[i], &q = hull[(i + 1) % hull.size()], &after = hull[(i + 2) % hull.size()];
    const ProfilePoint out = -r * turnedLeft(q - p).normalized(), nextOut = -r * turnedLeft(after - q).normalized();
    loop.push_back(SectionSegment::line(p + out, q + out));
    loop.push_back(SectionSegment::arc(q, q + out, q + nextOut, 1));
  }
  return loop;
}

Corners moved(const Corners& points, const ProfilePoint& by) {
  Corners result = points;
  for (ProfilePoint& p : result) p += by;
  return result;
}

void append(Corners& points, const Corners& more) {
  points.insert(points.end(), more.begin(), more.end());
}

Corners withShadows(const Corners& points, std::span<const ProfilePoint> shadows) {
  Corners all = points;
  for (const ProfilePoint& shadow : shadows) append(all, moved(points, shadow));
  return all;
}

SectionCutter hullCutter(Corners points, double radius) {
  return [points = std::move(points), radius](double grown) { return hullLoop(points, radius, grown); };
}

// Makes a loop counter-clockwise.
SectionLoop counterClockwise(SectionLoop loop) {
  if (areaOf(loop) >= 0.0) return loop;
  std::reverse(loop.begin(), loop.end());
  for (SectionSegment& segment : loop) segment = segment.reversed();
  return loop;
}

// An arc that the controlled point follows.
struct ArcMove {
  ProfilePoint centre;
  double radius;
  int turn;
  ProfilePoint out(double angle) const { return {std::cos(angle), std::sin(angle)}; }
  ProfilePoint at(double angle) const { return centre + radius * out(angle); }
  // Returns the angle by which the arc is longer at each end if its cutters grow.
  double longer(double grown) const {
    constexpr double kMost = 0.01;  // rad
    return turn * std::min(kMost, grown / radius);
  }
};

// Returns the area between two parallel curves: an arc and its image under a translation.
SectionCutter curtain(const ArcMove& arc, const ProfilePoint& corner, double radius, double from, double to,
                      const ProfilePoint& shadow) {
  return [=](double grown) {
    const ProfilePoint centre = arc.centre + corner, grow = grown * shadow.normalized();
    const double longer = arc.longer(grown);
    const ProfilePoint a = centre - grow + radius * arc.out(from - longer);
    const ProfilePoint b = centre - grow + radius * arc.out(to + longer);
    const ProfilePoint up = shadow + 2.0 * grow;
    return counterClockwise({SectionSegment::arc(centre - grow, a, b, arc.turn), SectionSegment::line(b, b + up),
                             SectionSegment::arc(centre - grow + up, b + up, a + up, -arc.turn),
                             SectionSegment::line(a + up, a)});
  };
}

// Returns the ring sector that a disc sweeps between two positions, without its round ends.
SectionCutter ring(const ArcMove& arc, const ProfilePoint& corner, double radius, double from, double to) {
  return [=](double grown) -> SectionLoop {
    const ProfilePoint centre = arc.centre + corner;
    const double outer = arc.radius + radius + grown, inner = arc.radius - radius - grown;
    const double first = from - arc.longer(grown), last = to + arc.longer(grown);
    const ProfilePoint a = centre + outer * arc.out(first), b = centre + outer * arc.out(last);
    constexpr double kLeast = 1e-6;  // mm
    if (inner < kLeast) {
      const ProfilePoint apex = centre - grown * arc.out(0.5 * (from + to));
      return counterClockwise(
          {SectionSegment::arc(centre, a, b, arc.turn), SectionSegment::line(b, apex), SectionSegment::line(apex, a)});
    }
    const ProfilePoint c = centre + inner * arc.out(last), d = centre + inner * arc.out(first);
    return counterClockwise({SectionSegment::arc(centre, a, b, arc.turn), SectionSegment::line(b, c),
                             SectionSegment::arc(centre, c, d, -arc.turn), SectionSegment::line(d, a)});
  };
}

ProfilePoint middleOf(const Corners& points) {
  ProfilePoint sum = ProfilePoint::Zero();
  for (const ProfilePoint& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// Returns the least distance of the middle from an edge of a hull of three corners or more.
double inRadius(const Corners& hull) {
  const ProfilePoint middle = middleOf(hull);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const ProfilePoint along = (hull[(i + 1) % hull.size()] - hull[i]).normalized();
    least = std::min(least, crossProduct(along, middle - hull[i]));
  }
  return least;
}

// Adds the area between the rings of the corners: the shape, smaller by the rise of the chords, along short chords.
void addInside(const SweptShape& shape, const Corners& hull, const ArcMove& arc, double from, double to,
               std::vector<SectionCutter>& cutters) {
  if (hull.size() < 2) return;
  constexpr double kShare = 0.2;  // largest rise of a chord, as a share of the half width of the shape
  const bool isFlat = hull.size() < 3;
  const double width = isFlat ? shape.radius : inRadius(hull);
  if (!(width > 0.0)) return;
  const double rise = std::min(kShare * width, arc.radius);
  const double step = 2.0 * std::acos(1.0 - rise / arc.radius);
  constexpr double kMostChords = 1000.0;
  const double chords = std::clamp(std::ceil(std::abs(to - from) / step), 1.0, kMostChords);
  Corners smaller = hull;
  const ProfilePoint middle = middleOf(hull);
  if (!isFlat)
    for (ProfilePoint& p : smaller) p += rise / width * (middle - p);
  const double radius = isFlat ? shape.radius - rise : shape.radius;
  for (double i = 0.0; i < chords; ++i) {
    Corners both = moved(smaller, arc.at(from + (to - from) * i / chords));
    append(both, moved(smaller, arc.at(from + (to - from) * (i + 1.0) / chords)));
    cutters.push_back(hullCutter(std::move(both), radius));
  }
}

// Returns the angles at which an arc is split: it is in pieces of at most 60°, and no direction is tangent to it within
// a piece.
std::vector<double> splitsOf(const ArcMove& arc, double from, double to, const Corners& directions) {
  constexpr double kLongest = M_PI / 3.0;
  const double least = 2e-7 / arc.radius;  // shorter pieces (mm) would be slivers
  std::vector<double> angles;
  const double low = std::min(from, to), high = std::max(from, to);
  const double pieces = std::max(1.0, std::ceil((high - low) / kLongest));
  for (double i = 0.0; i <= pieces; ++i) angles.push_back(low + (high - low) * i / pieces);
  for (const ProfilePoint& direction : directions) {
    const ProfilePoint normal = turnedLeft(direction);
    const double first = std::atan2(normal.y(), normal.x());
    for (double angle = first + M_PI * std::ceil((low - first) / M_PI); angle < high; angle += M_PI)
      angles.push_back(angle);
  }
  std::sort(angles.begin(), angles.end());
  std::vector<double> splits;
  for (const double angle : angles)
    if (splits.empty() || angle > splits.back() + least) splits.push_back(angle);
  splits.back() = high;
  if (arc.turn < 0) std::reverse(splits.begin(), splits.end());
  return splits;
}

std::vector<SectionCutter> arcCutters(const SweptShape& shape, const SectionSegment& move,
                                      std::span<const ProfilePoint> shadows) {
  const ArcMove arc{move.carrier.point, std::abs(move.carrier.radius), move.carrier.radius > 0.0 ? 1 : -1};
  const ProfilePoint start = move.from - arc.centre;
  const double from = std::atan2(start.y(), start.x()), to = from + move.length() / move.carrier.radius;
  const Corners hull = hullOf(shape.corners);
  const ProfilePoint middle = middleOf(hull);
  Corners directions(shadows.begin(), shadows.end());
  for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i) {
    directions.push_back(hull[(i + 1) % hull.size()] - hull[i]);
    directions.push_back(middle - hull[i]);
  }
  const std::vector<double> splits = splitsOf(arc, from, to, directions);
  std::vector<SectionCutter> cutters;
  for (const double angle : splits)
    cutters.push_back(hullCutter(withShadows(moved(hull, arc.at(angle)), shadows), shape.radius));
  for (std::size_t k = 0; k + 1 < splits.size(); ++k) {
    const double a = splits[k], b = splits[k + 1];
    const ProfilePoint out = arc.out(0.5 * (a + b));
    for (const ProfilePoint& corner : hull) {
      if (shape.radius > 0.0) cutters.push_back(ring(arc, corner, shape.radius, a, b));
      Corners inward(shadows.begin(), shadows.end());
      if (hull.size() > 1) inward.push_back(middle - corner);
      for (const ProfilePoint& shadow : inward) {
        // The disc's side away from the shadow; a shape's own middle only fills the sharp corner.
        const bool isShadow = hull.size() == 1;
        const double offset = !isShadow ? 0.0 : out.dot(shadow) < 0.0 ? shape.radius : -shape.radius;
        if (arc.radius + offset > 1e-6) cutters.push_back(curtain(arc, corner, arc.radius + offset, a, b, shadow));
      }
    }
    addInside(shape, hull, arc, a, b, cutters);
  }
  return cutters;
}

}  // namespace

SweptShape SweptShape::of(const RoundedPolygon& section) {
  return {{section.corners().begin(), section.corners().end()}, section.radius()};
}

SweptShape SweptShape::mirrored() const {
  SweptShape mirror = *this;
  for (ProfilePoint& p : mirror.corners) p.x() = -p.x();
  return mirror;
}

std::vector<SectionCutter> cuttersOf(const SweptShape& shape, const ProfileSegment& move,
                                     std::span<const ProfilePoint> shadows) {
  const SectionSegment path = SectionSegment::of(move);
  if (path.carrier.isCircle()) return arcCutters(shape, path, shadows);
  Corners all = moved(shape.corners, move.from);
  append(all, moved(shape.corners, move.to));
  return {hullCutter(withShadows(all, shadows), shape.radius)};
}

}  // namespace handwheel
