// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/BoreWall.h"

#include "base/NumberText.h"
#include "machining/program/ProgramErrors.h"
#include "machining/target/TargetSides.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kPointSlope = 0.02;  // tolerance of a drill's cone, on the tangent of 59°: a third of a degree

// Returns the bore at the upper end, which continues beyond it.
const TargetProfile& upperBore(const TargetSides& sides, double top) {
  const auto found = std::find_if(sides.bores.begin(), sides.bores.end(), [&](const TargetProfile& bore) {
    return bore.upperEnd() > top + TargetProfile::kJoin;
  });
  if (found == sides.bores.end())
    refuse({}, "target", "it has no bore that is open at its upper end",
           "Leave the drill away, or turn the part round.");
  return *found;
}

// Moves the lower end of the wall to the bottom.
void takeBottom(BoreWall& bore) {
  const ProfileSegment last = bore.wall.back();
  bore.depth = -last.to.y();
  const double height = last.from.y() - last.to.y();
  if (!last.isArc() && std::abs(height) <= TargetProfile::kJoin) {
    bore.bottom = BoreWall::Bottom::Flat;
    bore.wall.pop_back();
    return;
  }
  const double slope = height > 0.0 ? last.from.x() / height : 0.0;
  if (last.isArc() || std::abs(slope - kDrillPointSlope) > kPointSlope)
    refuse({}, "target", "the bottom of its bore is neither flat nor the cone of a drill of 118°",
           "Draw one of these, or write a program of your own.");
  bore.bottom = BoreWall::Bottom::Drilled;
}

}  // namespace

double BoreWall::leastRadius() const {
  double least = wall.empty() ? 0.0 : wall.front().from.x();
  for (const ProfileSegment& segment : wall) {
    const bool isCone = bottom == Bottom::Drilled && &segment == &wall.back();
    least = std::min(least, isCone ? segment.from.x() : segment.box().min().x());
  }
  return least;
}

BoreWall boreWallOf(const TargetProfile& target) {
  const Result<TargetSides> sides = sidesOf(target);
  if (!sides) refuse({}, "target", "its bore cannot be distinguished from its outside", "Choose another target.");
  const double top = target.upperEnd(), bottom = target.lowerEnd();
  BoreWall bore;
  for (const ProfileSegment& segment :
       upperBore(*sides, top).segments()) {  // upwards along the wall, and beyond the ends
    const double low = std::min(segment.from.y(), segment.to.y()), high = std::max(segment.from.y(), segment.to.y());
    if ((target.isClosed() && high <= bottom + TargetProfile::kJoin) || low >= top - TargetProfile::kJoin) continue;
    if (segment.to.y() < segment.from.y() - TargetProfile::kJoin)
      refuse({}, "target", "its bore has an undercut at z = " + roundedText(segment.at(0.5).y() - top),
             "Cut it by a program of your own.");
    ProfileSegment down = segment.reversed();
    if (!down.isArc()) {  // beyond the ends it is straight
      down.from.y() = std::min(down.from.y(), top);
      down.to.y() = std::max(down.to.y(), bottom);
    }
    down.from.y() -= top;
    down.to.y() -= top;
    bore.wall.insert(bore.wall.begin(), down);
  }
  if (bore.wall.empty()) refuse({}, "target", "it has no bore", "Leave the drill away.");
  if (!target.isClosed()) takeBottom(bore);
  if (bore.wall.empty()) refuse({}, "target", "its bore has no wall", "Leave the drill away.");
  return bore;
}

CutContour wallDownTo(const CutContour& wall, double z, double radius) {
  CutContour upper;
  for (const ProfileSegment& segment : wall) {
    if (segment.from.y() <= z + TargetProfile::kJoin) break;
    upper.push_back(segment);
    if (segment.to.y() >= z - TargetProfile::kJoin) continue;
    if (segment.isArc())
      refuse({}, "target", "the wall of its bore is curved where the point of the drill ends", "Take a smaller drill.");
    const double share = (segment.from.y() - z) / (segment.from.y() - segment.to.y());
    upper.back().to = segment.from + share * (segment.to - segment.from);
  }
  if (!upper.empty()) upper.push_back({upper.back().to, {radius, upper.back().to.y()}, 0.0});
  return upper;
}

}  // namespace handwheel
