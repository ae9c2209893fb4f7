// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/refit/SampledProfile.h"

#include "machining/EndPiece.h"
#include "machining/refit/Refit.h"
#include "machining/target/CurveFit.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kExactCurve = 1e-6;  // mm, of the lines and arcs of a curve

// Of the samples from `first` to before `end`, two at least.
Result<TargetProfile> sectionBetween(const TurnedProfile& part, std::size_t first, std::size_t end, double tolerance) {
  std::vector<ProfilePoint> outside, inside;
  for (std::size_t i = first; i < end; ++i) outside.emplace_back(part.radius(i), part.z(i));
  std::vector<ProfileSegment> outline = refitted(outside, tolerance, part.spacing());
  for (std::size_t i = end; i-- > first;) inside.emplace_back(part.inner(i), part.z(i));
  const bool isBored = std::any_of(inside.begin(), inside.end(), [](const ProfilePoint& p) { return p.x() > 0.0; });
  if (isBored) {
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

Result<TargetProfile> sectionOfEndPiece(const TurnedProfile& part, double tolerance) {
  const std::vector<TurnedProfile::Range> pieces = piecesOf(part);
  if (pieces.empty() || pieces.back().size() < 2) return sectionOf(part, tolerance);
  return sectionBetween(part, pieces.back().first, pieces.back().last, tolerance);
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
