// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/RoughAndFinish.h"

#include "base/NumberText.h"
#include "machining/program/ProgramErrors.h"
#include "machining/program/cycles/ContourCuts.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSameHeight = 1e-9;

// Returns the outside from the upper end to the lower, at z <= 0, without the flat ends.
CutContour outsideOf(const TargetProfile& target) {
  CutContour contour;
  const double top = target.upperEnd(), bottom = target.lowerEnd();
  for (const ProfileSegment& segment : target.segments()) {
    const auto isFlatAt = [&](double z) {
      return std::abs(segment.from.y() - z) < kSameHeight && std::abs(segment.to.y() - z) < kSameHeight;
    };
    if (isFlatAt(top) || isFlatAt(bottom)) continue;
    const ProfilePoint middle = segment.at(0.5);
    const auto extent = target.extentAt(middle.y());
    if (!extent || middle.x() < 0.5 * (extent->inner + extent->outer)) continue;  // part of the bore
    if (segment.to.y() < segment.from.y() - 1e-6)
      refuse({}, "target", "it has an undercut at z = " + roundedText(middle.y() - top),
             "Cut it with a grooving tool, by a program of your own.");
    ProfileSegment down = segment.reversed();
    down.from.y() -= top;
    down.to.y() -= top;
    contour.insert(contour.begin(), down);
  }
  if (contour.empty()) refuse({}, "target", "it has no outside to turn", "Choose another target.");
  return contour;
}

}  // namespace

Result<std::vector<ToolMove>> roughAndFinish(const TargetProfile& target, double barRadius, const CycleSettings& s) {
  try {
    if (!(s.depth > 0.01 && s.nose > 0.0 && s.allowance >= 0.0 && s.roughFeed > 0.0 && s.finishFeed > 0.0))
      refuse({}, "settings", "depth, nose and feeds are not all above 0", "Correct them.");
    if (target.largestRadius() > barRadius + 1e-6)
      refuse({}, "target", "it is thicker than the bar",
             "Take a bar of at least " + roundedText(2.0 * target.largestRadius()) + " mm.");
    return contourCuts(outsideOf(target), barRadius, s);
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
}

}  // namespace handwheel
