// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/RingLayout.h"

#include "base/Tolerance.h"
#include "nurbs/CircleSegments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr int kDeepest = 30;          // halvings of an arc; beyond, points coincide
constexpr double kHalvingStep = 1.3;  // height of a band that halves the count, in chords of its finer side

struct Outline {
  std::vector<ProfilePoint> points;
  double largestRadius = 0.0;
  bool isClosed = false;
};

Error tooMany(std::uint64_t limit) {
  return {ErrorCode::FileTooLarge, {"triangles", "", std::to_string(limit)}, {}, {}};
}

bool isCurved(const ProfileCurve& profile) {
  const auto arcs = profile.arcs();
  return std::any_of(arcs.begin(), arcs.end(), [](const BezierArc& arc) { return arc.chordError() > 0.0; });
}

// Returns the profile as chords that deviate from it by no more than the tolerance.
Result<Outline> flatten(const ProfileCurve& profile, double tolerance, std::uint64_t limit, Progress progress) {
  Outline outline;
  outline.points.push_back(profile.arcs().front().start());
  std::vector<std::pair<BezierArc, int>> waiting;
  for (const BezierArc& arc : profile.arcs()) {
    waiting.emplace_back(arc, 0);
    while (!waiting.empty()) {
      const auto [part, depth] = waiting.back();
      waiting.pop_back();
      if (depth < kDeepest && part.chordError() > tolerance) {
        const auto [left, right] = part.halves();
        waiting.emplace_back(right, depth + 1);
        waiting.emplace_back(left, depth + 1);
      } else if (part.end() != outline.points.back()) {
        outline.points.push_back(part.end());
        if (outline.points.size() > limit) return tooMany(limit);
      }
      if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    }
  }
  outline.isClosed = profile.isClosed();
  if (outline.isClosed) outline.points.back() = outline.points.front();  // equal but for rounding
  for (const ProfilePoint& p : outline.points) outline.largestRadius = std::max(outline.largestRadius, p.x());
  for (ProfilePoint& p : outline.points) {
    if (p.x() <= tolerance::kOnAxis * outline.largestRadius) p.x() = 0.0;
  }
  return outline;
}

double chord(const Ring& ring) {
  return 2.0 * std::numbers::pi * ring.radius / ring.segments;
}

double distance(const Ring& a, const Ring& b) {
  return std::hypot(a.radius - b.radius, a.z - b.z);
}

Ring between(const Ring& a, const Ring& b, double share, std::uint32_t segments) {
  return {a.radius + share * (b.radius - a.radius), a.z + share * (b.z - a.z), segments};
}

// The rings of one straight piece, so that from one to the next the count is at most halved. Chords of a flat end
// deviate by nothing, so there the count falls as fast as well-shaped triangles allow; elsewhere as the radius allows.
class Piece {
 public:
  Piece(const CircleSegments& circle, bool isFlatEnd) : m_circle(circle), m_isFlatEnd(isFlatEnd) {}

  std::vector<Ring> rings(const Ring& from, const Ring& to) const {
    if (from.radius >= to.radius) return inwards(from, to);
    std::vector<Ring> rings = inwards(to, from);
    std::reverse(rings.begin(), rings.end());
    return rings;
  }

 private:
  std::vector<Ring> inwards(const Ring& wide, const Ring& narrow) const {
    std::vector<Ring> rings = {wide};
    const bool toAxis = narrow.segments == 1;
    const int last = toAxis ? m_circle.levels() : m_circle.levelOf(narrow.segments);
    const double fall = wide.radius - narrow.radius;
    for (int level = m_circle.levelOf(wide.segments) + 1; wide.segments > 1 && level <= last; ++level) {
      const Ring before = rings.back();
      const double step = kHalvingStep * chord(before) * fall / distance(wide, narrow);
      double radius = std::max(before.radius - step, (before.radius + narrow.radius) / 2.0);
      if (!m_isFlatEnd) radius = std::min(radius, m_circle.reach(level));
      if (!toAxis && level == last && radius - narrow.radius < step / 2.0) break;
      rings.push_back(between(wide, narrow, (wide.radius - radius) / fall, m_circle.count(level)));
    }
    rings.push_back(narrow);
    return rings;
  }

  const CircleSegments& m_circle;
  bool m_isFlatEnd;
};

// Returns the number of bands between two rings; all but one have the finer count.
double divisions(const Ring& a, const Ring& b, double aspect) {
  const double mean = (chord(a) + chord(b)) / 2.0;
  return mean > 0.0 ? std::max(1.0, std::ceil(distance(a, b) / (aspect * mean))) : 1.0;
}

double triangles(const std::vector<Ring>& rings, double aspect) {
  double sum = 0.0;
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const Ring &a = rings[i - 1], &b = rings[i];
    sum += (divisions(a, b, aspect) - 1.0) * 2.0 * std::max(a.segments, b.segments);
    sum += static_cast<double>(bandTriangles(a, b));
  }
  return sum;
}

std::vector<Ring> divide(const std::vector<Ring>& rings, double aspect) {
  std::vector<Ring> result = {rings.front()};
  for (std::size_t i = 1; i < rings.size(); ++i) {
    const Ring &a = rings[i - 1], &b = rings[i];
    const double parts = divisions(a, b, aspect);
    for (int k = 1; k < parts; ++k) {
      result.push_back(between(a, b, k / parts, std::max(a.segments, b.segments)));
    }
    result.push_back(b);
  }
  return result;
}

// Returns rings at changes of the count and bends of the outline; ends included.
Result<std::vector<Ring>> outlineRings(const Outline& outline, const CircleSegments& circle, std::uint64_t limit,
                                       Progress progress) {
  const auto ringAt = [&](const ProfilePoint& p) -> Ring {
    return {p.x(), p.y(), p.x() > 0.0 ? circle.count(circle.levelAt(p.x())) : 1};
  };
  const ProfilePoint &first = outline.points.front(), &last = outline.points.back();
  std::vector<Ring> rings = {outline.isClosed ? ringAt(first) : Ring{0.0, first.y(), 1}};
  const auto goTo = [&](const Ring& ring, bool isFlatEnd) {
    const std::vector<Ring> piece = Piece(circle, isFlatEnd).rings(rings.back(), ring);
    rings.insert(rings.end(), piece.begin() + 1, piece.end());
  };
  if (first.x() > 0.0 && !outline.isClosed) goTo(ringAt(first), true);
  for (std::size_t i = 1; i < outline.points.size(); ++i) {
    goTo(ringAt(outline.points[i]), false);
    if (rings.size() > limit) return tooMany(limit);
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  }
  if (last.x() > 0.0 && !outline.isClosed) goTo({0.0, last.y(), 1}, true);
  return rings;
}

}  // namespace

std::uint64_t bandTriangles(const Ring& a, const Ring& b) {
  const std::uint64_t least = std::min(a.segments, b.segments), most = std::max(a.segments, b.segments);
  if (most == 1) return 0;
  return least == 1 ? most : least + most;
}

Result<std::vector<Ring>> computeRings(const ProfileCurve& profile, const TessellationOptions& options,
                                       Progress progress) {
  // The deviations of both directions add up.
  const double tolerance = isCurved(profile) ? options.chord / 2.0 : options.chord;
  const Result<Outline> outline = flatten(profile, tolerance, options.mostTriangles, progress);
  if (!outline) return outline.error();
  if (outline->largestRadius == 0.0) {
    return Error{ErrorCode::ElementMalformed, {"profile", "it lies on the axis"}, {}, {}};
  }
  const auto circle = CircleSegments::make(outline->largestRadius, tolerance);
  if (!circle) return tooMany(options.mostTriangles);
  const Result<std::vector<Ring>> rings = outlineRings(*outline, *circle, options.mostTriangles, progress);
  if (!rings) return rings.error();
  const double least = triangles(*rings, HUGE_VAL);
  if (least > static_cast<double>(options.mostTriangles)) return tooMany(options.mostTriangles);
  const double most =
      std::max(least, static_cast<double>(std::min(options.maxWellShapedTriangles, options.mostTriangles)));
  double aspect = options.aspect;
  while (triangles(*rings, aspect) > most) aspect *= 1.5;
  return divide(*rings, aspect);
}

}  // namespace handwheel
