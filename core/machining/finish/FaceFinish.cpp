// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/finish/FaceFinish.h"

#include "machining/measure/RoughnessGrade.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

const double kMostLean = std::tan(15.0 * M_PI / 180.0);
constexpr double kLeastWidth = 0.1;  // mm; a narrower face has no roughness that could be measured

bool isFace(const SectionSegment& segment) {
  const ProfilePoint along = segment.to - segment.from;
  return !segment.carrier.isCircle() && segment.pass != SectionSegment::kBar && std::abs(along.x()) > kLeastWidth &&
         std::abs(along.y()) <= kMostLean * std::abs(along.x());
}

// Returns the largest feed of the moves of a pass along a face; nothing if there are none or a feed is not known.
std::optional<double> feedAlong(const TurningPass& pass, const SectionSegment& face) {
  const double nose = pass.tool ? pass.tool->noseRadius : pass.noseRadius, reach = nose + 1e-3;
  const double low = std::min(face.from.x(), face.to.x()) - reach, high = std::max(face.from.x(), face.to.x()) + reach;
  std::optional<double> largest;
  for (std::size_t i = 1; i < pass.path.size(); ++i) {
    const ProfilePoint &a = pass.path[i - 1], &b = pass.path[i], by = b - a;
    const bool isRadial = std::abs(by.y()) <= kMostLean * std::abs(by.x()) && std::abs(by.x()) > 0.0;
    const bool isThere = std::max(a.x(), b.x()) > low && std::min(a.x(), b.x()) < high;
    if (!isRadial || !isThere || face.carrier.distance(0.5 * (a + b)) > reach) continue;
    const double speed = i < pass.speeds.size() ? pass.speeds[i] : 0.0;
    const double turns = (pass.times[i] - pass.times[i - 1]) * speed / 60.0;
    if (!(turns > 0.0)) return std::nullopt;
    largest = std::max(largest.value_or(0.0), by.norm() / turns);
  }
  return largest;
}

}  // namespace

std::vector<FaceFinish> faceFinish(const TurnedSection& section, const TurningPasses& passes) {
  std::vector<FaceFinish> faces;
  for (const SharedLoop& loop : section.loops()) {
    for (const SectionSegment& segment : loop.segments()) {
      if (!isFace(segment) || segment.pass >= passes.size()) continue;
      const TurningPass& pass = *passes[segment.pass];
      const std::optional<double> feed = feedAlong(pass, segment);
      if (!feed) continue;
      constexpr double kFromAxis = 1e-6;  // mm
      const auto [least, outer] = std::minmax(segment.from.x(), segment.to.x());
      const double inner = least > kFromAxis ? least : 0.0;
      const double nose = pass.tool ? pass.tool->noseRadius : pass.noseRadius;
      faces.push_back(
          {0.5 * (segment.from.y() + segment.to.y()), inner, outer, segment.pass, *feed, idealRoughness(*feed, nose)});
    }
  }
  std::sort(faces.begin(), faces.end(), [](const FaceFinish& a, const FaceFinish& b) { return a.height < b.height; });
  return faces;
}

}  // namespace handwheel
