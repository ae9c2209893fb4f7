// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/FaceCuts.h"

#include "machining/program/ProgramErrors.h"
#include "machining/program/cycles/CyclePath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kLeastFaced = 1e-3;       // mm; a smaller height is rounding
constexpr double kDeepestByNose = 1.5;     // depth in nose radii, so that nothing is left between passes
constexpr double kBesideFace = 0.5;        // mm, distance from the face on return
constexpr double kMostFacings = 10'000.0;  // passes

// Faces down to a height, and returns outside.
void faceAt(CyclePath& path, double height, double inward, double outside, double nose) {
  const double centre = height + nose;
  path.rapid({outside, path.at().y()});
  path.rapid({outside, centre});
  path.feed({inward, centre});
  path.rapid({inward, centre + kBesideFace});
  path.rapid({outside, centre + kBesideFace});
}

}  // namespace

EndStock EndStock::of(const TurnedProfile& part, double base, double upperEnd) {
  EndStock end;
  double narrowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = part.size(); i-- > 0 && part.z(i) + base > upperEnd;) {
    if (!part.hasMaterial(i)) continue;
    end.height = std::max(end.height, part.z(i) + base - upperEnd);
    narrowest = std::min(narrowest, part.inner(i));
  }
  if (std::isfinite(narrowest)) end.hole = narrowest;
  return end;
}

Result<std::vector<ToolMove>> faceCuts(const EndStock& end, double barRadius, const CycleSettings& s) {
  if (!(end.height > kLeastFaced)) return std::vector<ToolMove>();
  try {
    const double left = std::min({s.allowance, s.nose, end.height});
    const double count = std::ceil((end.height - left) / std::min(s.depth, kDeepestByNose * s.nose));
    if (!(count <= kMostFacings))
      refuse({}, "depth", "the face takes too many passes", "Use a larger depth of cut and nose radius.");
    const double outside = barRadius + s.nose + s.clearance, inward = std::max(0.0, end.hole - s.nose);
    const double away = end.height + s.nose + 10.0 * s.clearance;
    CyclePath path(s);
    const int passes = static_cast<int>(count);
    if (passes > 0) {
      path.tool(s.roughTool, s.roughFeed);
      path.rapid({outside, away});
      for (int i = 1; i <= passes; ++i)
        faceAt(path, std::lerp(end.height, left, static_cast<double>(i) / passes), inward, outside, s.nose);
      path.rapid({outside, away});
    }
    path.tool(s.finishTool, s.finishFeed);
    path.rapid({outside, away});
    faceAt(path, 0.0, inward, outside, s.nose);
    path.rapid({outside, away});
    return path.take();
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
}

}  // namespace handwheel
