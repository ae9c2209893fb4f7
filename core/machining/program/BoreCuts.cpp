// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/BoreCuts.h"

#include "base/NumberText.h"
#include "machining/program/ContourCuts.h"
#include "machining/program/ProgramErrors.h"
#include "machining/target/TargetSides.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kBesideWall = 0.5;     // mm, of the nose in the hole, and of the drill before the end of the bar
constexpr double kBehindBar = 0.3;      // mm, between the back of a boring bar and the hole
constexpr double kLeastToBore = 0.2;    // mm, on the radius, that a drill leaves
constexpr double kMostDepth = 1.0;      // mm, of a level: bars are slender
constexpr double kMostAllowance = 0.2;  // mm
constexpr double kDrillSpeed = 20.0;    // m/min, of high-speed steel
constexpr double kDrillFeed = 0.1;      // mm in a turn
constexpr double kBefore = 5.0;         // mm

// The wall of the bore from the upper end, z = 0, to the lower; r is the radius.
CutContour wallOf(const TargetProfile& target) {
  if (!target.isClosed())
    refuse({}, "target", "it has no bore that goes through", "Write a program of your own for a blind one.");
  const Result<TargetSides> sides = sidesOf(target);
  if (!sides || sides->bores.empty())
    refuse({}, "target", "its bore cannot be told from its outside", "Choose another target.");
  const double top = target.upperEnd(), bottom = target.lowerEnd();
  CutContour wall;
  for (const ProfileSegment& segment : sides->bores.front().segments()) {  // up along the wall, and beyond the ends
    const double low = std::min(segment.from.y(), segment.to.y()), high = std::max(segment.from.y(), segment.to.y());
    if (high <= bottom + TargetProfile::kJoin || low >= top - TargetProfile::kJoin) continue;
    if (segment.to.y() < segment.from.y() - TargetProfile::kJoin)
      refuse({}, "target", "its bore has an undercut at z = " + roundedText(segment.at(0.5).y() - top),
             "Cut it by a program of your own.");
    ProfileSegment down = segment.reversed();
    if (!down.isArc()) {  // beyond the ends it goes straight on
      down.from.y() = std::min(down.from.y(), top);
      down.to.y() = std::max(down.to.y(), bottom);
    }
    down.from.y() -= top;
    down.to.y() -= top;
    wall.insert(wall.begin(), down);
  }
  if (wall.empty()) refuse({}, "target", "it has no bore", "Leave the drill away.");
  return wall;
}

double leastRadius(const CutContour& wall) {
  double least = wall.front().from.x();
  for (const ProfileSegment& segment : wall) least = std::min(least, segment.box().min().x());
  return least;
}

// mm, how far behind its tip a bar reaches in r.
double backOf(const LatheTool& bar) {
  double least = 0.0;
  for (const auto* sections : {&bar.cutting, &bar.holder}) {
    for (const RoundedSection& section : *sections)
      for (const ProfilePoint& p : section.corners()) least = std::min(least, p.x() - section.radius());
  }
  return -least;
}

std::shared_ptr<const LatheTool> barFor(double hole, const LatheTools& tools) {
  std::shared_ptr<const LatheTool> best;
  for (const auto& tool : tools) {
    if (tool->kind != LatheToolKind::BoringBar) continue;
    const bool fits = (hole - kBesideWall) - backOf(*tool) > kBehindBar - hole;
    if (fits && (!best || backOf(*tool) > backOf(*best))) best = tool;
  }
  return best;
}

std::shared_ptr<const LatheTool> drillOf(double diameter, const LatheTools& tools) {
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const auto& tool) {
    return tool->kind == LatheToolKind::Drill && std::abs(2.0 * tool->reach() - diameter) < 1e-6;
  });
  return found == tools.end() ? nullptr : *found;
}

BoreTools toolsFor(const CutContour& wall, double drill, const LatheTools& tools) {
  const double hole = 0.5 * drill, least = leastRadius(wall);
  if (hole > least - kLeastToBore)
    refuse({}, "drill", "it is too large for the bore",
           "Take one of at most " + roundedText(2.0 * (least - kLeastToBore), 3) + " mm.");
  BoreTools chosen{drillOf(drill, tools), barFor(hole, tools)};
  if (!chosen.drill) refuse({}, "drill", "there is none of " + roundedText(drill, 3) + " mm", "Take another diameter.");
  if (!chosen.bar) refuse({}, "drill", "no boring bar fits into its hole", "Take a larger one.");
  return chosen;
}

CycleSettings inHole(const CycleSettings& settings, const LatheTool& bar, double below) {
  CycleSettings inside = settings;
  inside.nose = bar.noseRadius;
  inside.depth = std::min(settings.depth, kMostDepth);
  inside.allowance = std::min(settings.allowance, kMostAllowance);
  inside.clearance = kBesideWall;
  inside.roughTool = inside.finishTool = settings.boreTool;
  inside.room = below;
  return inside;
}

// depth: mm, of the tip.
std::vector<ToolMove> drillTo(double depth, double diameter, const CycleSettings& settings) {
  ToolMove move;
  move.tool = static_cast<std::uint16_t>(settings.drillTool);
  move.spin = 1;
  move.isPerRevolution = true;
  move.spindle = std::min(settings.mostSpindle, std::round(1000.0 * kDrillSpeed / (M_PI * diameter)));
  std::vector<ToolMove> moves;
  const auto go = [&](ToolMove::Kind kind, double z) {
    move.kind = kind;
    move.feed = kind == ToolMove::Kind::Feed ? kDrillFeed : 0.0;
    move.from = moves.empty() ? ProfilePoint(0.0, kBefore) : moves.back().to;
    move.to = {0.0, z};
    moves.push_back(move);
  };
  go(ToolMove::Kind::Rapid, kBefore);
  go(ToolMove::Kind::Feed, -depth);
  go(ToolMove::Kind::Rapid, kBefore);
  return moves;
}

}  // namespace

Result<BoreTools> boreTools(const TargetProfile& target, double drill, const LatheTools& tools) {
  try {
    return toolsFor(wallOf(target), drill, tools);
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
}

double drillFor(const TargetProfile& target, const LatheTools& tools) {
  double largest = 0.0;
  for (const auto& tool : tools) {
    const double diameter = 2.0 * tool->reach();
    if (tool->kind == LatheToolKind::Drill && diameter > largest && boreTools(target, diameter, tools))
      largest = diameter;
  }
  return largest;
}

// Boring is turning the outside of what is mirrored: the wall at a distance from the axis that has the hole outside.
Result<std::vector<ToolMove>> drillAndBore(const TargetProfile& target, const BoreTools& tools,
                                           const CycleSettings& settings, double below) {
  try {
    CutContour wall = wallOf(target);
    const double hole = tools.drill->reach(), mirror = 2.0 * target.largestRadius() + 100.0;
    const CycleSettings inside = inHole(settings, *tools.bar, below);
    // As deep as the nose goes, and by its point, which in the simulation is round, deeper.
    const double deep = 2.0 * inside.nose + inside.allowance + inside.overrun + kBesideWall + hole;
    if (deep > below - kBesideWall)
      refuse({}, "bar", "the drill would come out of it in the chuck",
             "Take a bar that is at least " + roundedText(deep - below + kBesideWall, 2) + " mm longer.");
    for (ProfileSegment& segment : wall) {
      segment.from.x() = mirror - segment.from.x();
      segment.to.x() = mirror - segment.to.x();
      segment.bulge = -segment.bulge;
    }
    std::vector<ToolMove> moves = drillTo(target.length() + deep, 2.0 * hole, settings);
    for (ToolMove& move : contourCuts(std::move(wall), mirror - hole, inside)) {
      for (ProfilePoint* each : {&move.from, &move.to, &move.centre}) each->x() = mirror - each->x();
      move.turn = static_cast<std::int8_t>(-move.turn);
      moves.push_back(move);
    }
    return moves;
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
}

}  // namespace handwheel
