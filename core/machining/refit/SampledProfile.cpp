// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/refit/SampledProfile.h"

#include "machining/refit/Refit.h"
#include "machining/target/CurveFit.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kExactCurve = 1e-6;  // mm, tolerance of the lines and arcs of a curve

// A run of samples, whose sides are read one after the other. Beside a bore, samples without material are the wall of
// the bore on both sides: the run ends before them, halfway if the part has a face there.
class SampleRun {
 public:
  // first to before end, two samples at least.
  SampleRun(const TurnedProfile& part, std::size_t first, std::size_t end) : m_part(part), m_first(first), m_end(end) {
    std::size_t low = first, high = end;
    while (low < high && !part.hasMaterial(low)) ++low;
    while (low < high && !part.hasMaterial(high - 1)) --high;
    if (high - low < 2) return;
    if (low > first && part.inner(low) > 0.0) {
      m_isFacedBelow = isWall(low, low - 1);
      m_first = m_isFacedBelow ? low : low - 1;
    }
    if (high < end && part.inner(high - 1) > 0.0) {
      m_isFacedAbove = isWall(high - 1, high);
      m_end = m_isFacedAbove ? high : high + 1;
    }
  }
  bool isBored() const {
    for (std::size_t i = m_first; i < m_end; ++i)
      if (m_part.inner(i) > 0.0) return true;
    return false;
  }
  std::vector<ProfilePoint> outside() const {
    return side([this](std::size_t i) { return m_part.radius(i); });
  }
  std::vector<ProfilePoint> inside() const {
    return side([this](std::size_t i) { return m_part.inner(i); });
  }

 private:
  static constexpr double kSteepest = 2.0;  // a steeper slope is a wall

  bool isSteep(double from, double to) const { return std::abs(to - from) > kSteepest * m_part.spacing(); }
  // Returns true at a wall, or at a sharp edge between outside and bore.
  bool isWall(std::size_t last, std::size_t beyond) const {
    return isSteep(m_part.radius(last), m_part.radius(beyond)) || isSteep(m_part.inner(last), m_part.inner(beyond));
  }
  // Returns the radius half a sample beyond the last one, extrapolated.
  double beyond(double last, double before) const {
    return isSteep(last, before) ? last : std::max(1.5 * last - 0.5 * before, 0.0);
  }
  template <class Radius>
  std::vector<ProfilePoint> side(const Radius& radius) const {
    const double half = 0.5 * m_part.spacing();
    std::vector<ProfilePoint> points;
    if (m_isFacedBelow) points.emplace_back(beyond(radius(m_first), radius(m_first + 1)), m_part.z(m_first) - half);
    for (std::size_t i = m_first; i < m_end; ++i) points.emplace_back(radius(i), m_part.z(i));
    if (m_isFacedAbove) points.emplace_back(beyond(radius(m_end - 1), radius(m_end - 2)), m_part.z(m_end - 1) + half);
    return points;
  }

  const TurnedProfile& m_part;
  std::size_t m_first, m_end;
  bool m_isFacedBelow = false, m_isFacedAbove = false;
};

// Returns the section of the samples from `first` to before `end`, two at least.
Result<TargetProfile> sectionBetween(const TurnedProfile& part, std::size_t first, std::size_t end, double tolerance) {
  const SampleRun run(part, first, end);
  std::vector<ProfileSegment> outline = refitted(run.outside(), tolerance, part.spacing());
  if (run.isBored()) {
    std::vector<ProfilePoint> inside = run.inside();
    std::reverse(inside.begin(), inside.end());
    const auto bore = refitted(inside, tolerance, part.spacing());
    outline.push_back({outline.back().to, bore.front().from, 0.0});
    outline.insert(outline.end(), bore.begin(), bore.end());
    outline.push_back({outline.back().to, outline.front().from, 0.0});
  }
  return TargetProfile::make(std::move(outline));
}

}  // namespace

Result<TargetProfile> sectionOf(const TurnedProfile& part, double tolerance) {
  return sectionBetween(part, 0, part.size(), tolerance);
}

Result<TargetProfile> sectionOf(const ProfileCurve& curve, double tolerance) {
  std::vector<ProfileSegment> outline;
  for (const BezierArc& arc : curve.arcs()) {
    if (arc.degree == 1) {
      outline.push_back({arc.start(), arc.end(), 0.0});
      continue;
    }
    const auto pieces = fitSegments([&](double t) { return arc.derivatives(t)[0]; }, std::min(tolerance, kExactCurve));
    outline.insert(outline.end(), pieces.begin(), pieces.end());
  }
  return TargetProfile::make(std::move(outline));
}

TurnedProfile sampled(const TargetProfile& target, double spacing) {
  const StockCylinder stock{2.0 * target.largestRadius(), target.length(), 0.0};
  TurnedProfile part(stock, spacing);
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double z = std::min(target.lowerEnd() + part.z(i), target.upperEnd());
    const auto extent = target.extentAt(z);
    part.limitOuter(i, extent ? extent->outer : 0.0);
    if (extent && extent->inner > 0.0) part.limitInner(i, extent->inner);
  }
  return part;
}

}  // namespace handwheel
