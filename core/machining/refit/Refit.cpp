// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/refit/Refit.h"

#include "machining/refit/ArcNurbs.h"
#include "machining/target/CornerFit.h"
#include "machining/target/CurveFit.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace handwheel {

namespace {

using Side = std::vector<ProfilePoint>;
using SegmentChain = std::vector<ProfileSegment>;

constexpr double kExactly = 1e-7;  // mm, tolerance of surfaces that a tool left exactly
constexpr double kShort = 200.0;   // in tolerances; longer segments stay as they were found

// The arcs through two points that pass a third one within a tolerance, by their half angle b. With y the height of the
// point above the middle of the chord 2c, x its position along it, and A = (c² - x² - y²) / 2c, its distance from the
// circle is |y cos b - A sin b|, but for terms of second order in distance over radius.
class HalfAngles {
 public:
  HalfAngles(const ProfilePoint& from, const ProfilePoint& to, double tolerance)
      : m_middle(0.5 * (from + to)), m_half(0.5 * (to - from).norm()), m_tolerance(tolerance) {
    if (m_half > 0.0) m_along = (to - from) / (2.0 * m_half);
  }
  bool isEmpty() const { return !(m_half > 0.0) || m_low > m_high; }
  void pass(const ProfilePoint& p) {
    const ProfilePoint v = p - m_middle;
    const double x = v.dot(m_along), y = m_along.y() * v.x() - m_along.x() * v.y();  // above: on the right
    const double a = (m_half * m_half - x * x - y * y) / (2.0 * m_half), size = std::hypot(a, y);
    if (size <= m_tolerance) return;
    const double angle = std::atan2(y, a), width = std::asin(m_tolerance / size);
    m_low = std::max(m_low, angle - width);
    m_high = std::min(m_high, angle + width);
  }
  // Returns zero, a line, if it is in the range. An arc on the right of its chord turns counter-clockwise.
  double best() const { return m_low <= 0.0 && m_high >= 0.0 ? 0.0 : 0.5 * (m_low + m_high); }

 private:
  static constexpr double kMost = 0.49 * M_PI;  // less than a half circle

  ProfilePoint m_middle, m_along{1.0, 0.0};
  double m_half, m_tolerance;
  double m_low = -kMost, m_high = kMost;
};

// Joins short neighbours while one line or arc is within the tolerance of all samples and corners.
class Joining {
 public:
  Joining(const Side& points, const SegmentChain& segments, double chord)
      : m_points(points), m_segments(segments), m_chord(chord) {
    const bool isUp = points.back().y() >= points.front().y();
    std::size_t i = 0;
    for (const ProfileSegment& s : segments) {
      while (i < points.size() && (isUp ? points[i].y() <= s.from.y() : points[i].y() >= s.from.y())) ++i;
      m_first.push_back(i);
    }
    m_first.push_back(points.size() - 1);
  }

  SegmentChain joined() const {
    SegmentChain result;
    for (std::size_t at = 0; at < m_segments.size();) {
      std::size_t step = 1;
      while (at + 2 * step <= m_segments.size() && over(at, at + 2 * step)) step *= 2;
      std::size_t end = at + step;
      for (std::size_t half = step; half > 0; half /= 2) {
        if (end + half <= m_segments.size() && over(at, end + half)) end += half;
      }
      if (end > at + 1)
        result.push_back(*over(at, end));
      else if (isAcross(m_segments[at]))
        addSamples(result, at);
      else
        result.push_back(m_segments[at]);
      at = end;
    }
    return result;
  }

 private:
  // Between two samples an arc may reach over the axis.
  static bool isAcross(const ProfileSegment& s) { return s.box().min().x() < 0.0; }

  // Adds lines through the samples of one segment.
  void addSamples(SegmentChain& chain, std::size_t segment) const {
    ProfilePoint at = m_segments[segment].from;
    const auto goOnTo = [&](const ProfilePoint& p) {
      if (p != at) chain.push_back({at, p, 0.0});
      at = p;
    };
    for (std::size_t k = m_first[segment]; k < m_first[segment + 1]; ++k) goOnTo(m_points[k]);
    goOnTo(m_segments[segment].to);
  }

  // Returns one segment that replaces those from `first` to before `end`; at least two.
  std::optional<ProfileSegment> over(std::size_t first, std::size_t end) const {
    HalfAngles angles(m_segments[first].from, m_segments[end - 1].to, m_chord);
    for (std::size_t i = first; i < end && !angles.isEmpty(); ++i) {
      if (m_segments[i].length() > kShort * m_chord) return std::nullopt;
      if (i > first) angles.pass(m_segments[i].from);
      for (std::size_t k = m_first[i]; k < m_first[i + 1] && !angles.isEmpty(); ++k) angles.pass(m_points[k]);
    }
    if (angles.isEmpty()) return std::nullopt;
    const ProfileSegment found{m_segments[first].from, m_segments[end - 1].to, std::tan(0.5 * angles.best())};
    return !isAcross(found) && passes(found, first, end) ? std::optional<ProfileSegment>(found) : std::nullopt;
  }

  // Checks exactly: if the tolerance is not small compared to a radius, the terms of second order count.
  bool passes(const ProfileSegment& found, std::size_t first, std::size_t end) const {
    const auto isNear = [&](const ProfilePoint& p) { return (found.nearest(p) - p).norm() <= m_chord; };
    for (std::size_t i = first; i < end; ++i) {
      if (!isNear(m_segments[i].from)) return false;
      for (std::size_t k = m_first[i]; k < m_first[i + 1]; ++k) {
        if (!isNear(m_points[k])) return false;
      }
    }
    return true;
  }

  const Side& m_points;
  const SegmentChain& m_segments;
  double m_chord;
  std::vector<std::size_t> m_first;  // for each segment, the first sample beyond its beginning
};

// Adds a line from the end of the last segment to this point: a flat end of the part.
void goTo(SegmentChain& segments, const ProfilePoint& p) {
  if (!segments.empty() && segments.back().to != p) segments.push_back({segments.back().to, p, 0.0});
}

SegmentChain outlineSegments(const std::vector<Side>& sides, bool isClosed, double chord, double spacing) {
  SegmentChain all;
  for (const Side& side : sides) {
    goTo(all, side.front());
    const SegmentChain fitted = refitted(side, chord, spacing);
    all.insert(all.end(), fitted.begin(), fitted.end());
  }
  if (isClosed) goTo(all, sides.front().front());
  std::erase_if(all, [](const ProfileSegment& s) { return s.from == s.to; });
  return all;
}

Result<ProfileCurve> curveOf(const std::vector<Side>& sides, bool isClosed, double chord, double spacing, double base) {
  SegmentChain segments = outlineSegments(sides, isClosed, chord, spacing);
  if (segments.empty()) return Error{ErrorCode::ElementMalformed, {"profile", "it has no extent"}, {}, {}};
  for (ProfileSegment& s : segments) {
    s.from.y() += base;
    s.to.y() += base;
  }
  return ProfileCurve::make(nurbsOf(segments));
}

}  // namespace

std::vector<ProfileSegment> refitted(const std::vector<ProfilePoint>& points, double chord, double spacing) {
  const double exact = std::min(kExactly, chord);
  const SegmentChain found = sharpened(fitSegments(points, exact), spacing, chord);
  return Joining(points, found, chord).joined();
}

Result<TurnedCurves> curvesOf(const TurnedOutline& outline, double chord, double spacing, double base) {
  Result<ProfileCurve> outside = curveOf(outline.sides, outline.isClosed, chord, spacing, base);
  if (!outside) return outside.error();
  TurnedCurves curves{std::move(outside).value(), {}};
  for (const Side& cavity : outline.cavities) {
    Result<ProfileCurve> curve = curveOf({cavity}, false, chord, spacing, base);
    if (!curve) return curve.error();
    curves.cavities.push_back(std::move(curve).value());
  }
  return curves;
}

}  // namespace handwheel
