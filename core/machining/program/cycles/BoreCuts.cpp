// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/BoreCuts.h"

#include "base/NumberText.h"
#include "machining/program/ProgramErrors.h"
#include "machining/program/cycles/BoreWall.h"
#include "machining/target/TargetSides.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kBesideWall = 0.5;     // mm, gap of the nose in the hole, and of the drill before the end of the bar
constexpr double kBehindBar = 0.3;      // mm, between the back of a boring bar and the hole
constexpr double kLeastToBore = 0.2;    // mm on the radius, least stock that a drill leaves
constexpr double kMostBarDepth = 1.0;   // mm, limit of a level: bars are slender
constexpr double kMostAllowance = 0.2;  // mm
constexpr double kDrillSpeed = 20.0;    // m/min, for high-speed steel
constexpr double kDrillFeed = 0.1;      // mm in a turn
constexpr double kBefore = 5.0;         // mm
constexpr double kAboveFlat = 0.3;      // mm, distance of the drill's point above a flat bottom
constexpr double kAboveRim = 0.5;       // mm, distance of a bar above the remains of that point
constexpr double kFaceDepth = 0.25;     // mm, level of a flat bottom: the edge of a bar slopes back by twice that
constexpr double kSameRadius = 1e-6;    // mm, on the radius

// Returns the reach of a bar behind its tip in r, mm.
double backOf(const LatheTool& bar) {
  double least = 0.0;
  for (const auto* sections : {&bar.cutting, &bar.holder}) {
    for (const RoundedPolygon& section : *sections)
      for (const ProfilePoint& p : section.corners()) least = std::min(least, p.x() - section.radius());
  }
  return -least;
}

// Returns the z above which a bar is clear of the remains of the drill's point over a flat bottom, mm.
double rimOf(const BoreWall& bore, double hole) {
  return -bore.depth + kAboveFlat + hole / kDrillPointSlope + kAboveRim;
}

// most: mm, largest reach behind its tip.
std::shared_ptr<const LatheTool> barFor(double hole, double most, const LatheTools& tools) {
  std::shared_ptr<const LatheTool> best;
  for (const auto& tool : tools) {
    if (tool->kind != LatheToolKind::BoringBar) continue;
    const bool fits = (hole - kBesideWall) - backOf(*tool) > kBehindBar - hole && backOf(*tool) < most;
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

// Returns true if the drill alone makes the bore: it goes through, or ends in the drill's cone.
bool isDrilledOnly(const BoreWall& bore, double hole) {
  return bore.bottom != BoreWall::Bottom::Flat &&
         std::all_of(bore.wall.begin(), bore.wall.end(),
                     [hole](const ProfileSegment& s) { return s.box().max().x() <= hole + kSameRadius; });
}

void checkDrill(const BoreWall& bore, double hole) {
  const double least = bore.leastRadius();
  const bool isExact = bore.bottom != BoreWall::Bottom::Flat && std::abs(hole - least) <= kSameRadius;
  if (hole > least - kLeastToBore && !isExact)
    refuse({}, "drill", "it is too large for the bore",
           "Take one of at most " + roundedText(2.0 * (least - kLeastToBore), 3) + " mm.");
  if (bore.bottom == BoreWall::Bottom::Flat && rimOf(bore, hole) > -kBesideWall)
    refuse({}, "drill", "its point is longer than the bore is deep", "Take a smaller one.");
}

BoreTools toolsFor(const BoreWall& bore, double drill, const LatheTools& tools) {
  const double hole = 0.5 * drill;
  checkDrill(bore, hole);
  BoreTools chosen{drillOf(drill, tools), nullptr};
  if (!chosen.drill) refuse({}, "drill", "there is none of " + roundedText(drill, 3) + " mm", "Take another diameter.");
  if (isDrilledOnly(bore, hole)) return chosen;
  // Over a flat bottom the bar comes to the axis.
  const bool isFlat = bore.bottom == BoreWall::Bottom::Flat;
  chosen.bar = barFor(hole, isFlat ? bore.leastRadius() - kBehindBar : std::numeric_limits<double>::infinity(), tools);
  if (!chosen.bar) refuse({}, "drill", "no boring bar fits into its hole", "Take a larger one.");
  return chosen;
}

CycleSettings inHole(const CycleSettings& settings, const LatheTool& bar, double below) {
  CycleSettings inside = settings;
  inside.nose = bar.noseRadius;
  inside.depth = std::min(settings.depth, kMostBarDepth);
  inside.allowance = std::min(settings.allowance, kMostAllowance);
  inside.clearance = kBesideWall;
  inside.roughTool = inside.finishTool = settings.boreTool;
  inside.room = below;
  return inside;
}

// depth: mm, depth of the tip.
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

// Boring is turning the outside of the mirrored wall: the wall at a distance from the axis that has the hole outside.
// hole: mm, radius from which it is bored.
void bore(std::vector<ToolMove>& moves, CutContour wall, double hole, const CycleSettings& inside) {
  double largest = hole;
  for (const ProfileSegment& segment : wall) largest = std::max(largest, segment.box().max().x());
  const double mirror = 2.0 * largest + 100.0;
  for (ProfileSegment& segment : wall) {
    segment.from.x() = mirror - segment.from.x();
    segment.to.x() = mirror - segment.to.x();
    segment.bulge = -segment.bulge;
  }
  for (ToolMove& move : contourCuts(std::move(wall), mirror - hole, inside)) {
    for (ProfilePoint* each : {&move.from, &move.to, &move.centre}) each->x() = mirror - each->x();
    move.turn = static_cast<std::int8_t>(-move.turn);
    moves.push_back(move);
  }
}

// Cuts levels from the axis outward, from one height (mm) down to another. They begin and end in front of the bar.
void faceInside(std::vector<ToolMove>& moves, double rim, double bottom, double radius, const CycleSettings& inside) {
  ToolMove move = moves.back();  // its tool and speeds
  move.turn = 0;
  const double before = move.to.y();
  const auto go = [&](ToolMove::Kind kind, double r, double z) {
    move.kind = kind;
    move.feed = kind == ToolMove::Kind::Feed ? inside.roughFeed : 0.0;
    move.from = moves.back().to;
    move.to = {r, z};
    moves.push_back(move);
  };
  go(ToolMove::Kind::Rapid, inside.nose, before);
  const int levels = static_cast<int>(std::ceil((rim - bottom) / kFaceDepth));
  for (int i = 1; i <= levels; ++i) {
    const double z = std::max(bottom, rim - i * kFaceDepth);
    go(i == 1 ? ToolMove::Kind::Rapid : ToolMove::Kind::Feed, inside.nose, z + kFaceDepth);
    go(ToolMove::Kind::Feed, inside.nose, z);
    go(ToolMove::Kind::Feed, radius, z);
    go(ToolMove::Kind::Feed, radius - kBesideWall, z + kBesideWall);
    go(ToolMove::Kind::Rapid, inside.nose, z + kBesideWall);
  }
  go(ToolMove::Kind::Rapid, inside.nose, before);
}

// Bores the wall above the remains of the drill, those in levels from the axis, then wall and bottom in one.
void boreToFlat(std::vector<ToolMove>& moves, const BoreWall& blind, double hole, const CycleSettings& inside) {
  const double rim = rimOf(blind, hole), radius = blind.leastRadius() - inside.allowance;
  bore(moves, wallDownTo(blind.wall, rim, hole), hole, inside);
  faceInside(moves, rim, -blind.depth + inside.allowance, radius, inside);
  CutContour all = blind.wall;
  const double end = inside.nose + inside.clearance;  // the path continues by that, to the axis
  all.push_back({all.back().to, {end, -blind.depth}, 0.0});
  CycleSettings along = inside;
  along.depth = 2.0 * blind.leastRadius();  // no more levels
  bore(moves, std::move(all), end, along);
}

// Bores as far as the cone of the drill, which is the bottom.
void boreToCone(std::vector<ToolMove>& moves, const BoreWall& blind, double hole, const CycleSettings& inside) {
  CutContour wall = blind.wall;
  ProfileSegment& cone = wall.back();
  const double width = cone.from.x() - hole;
  if (width > kSameRadius)
    cone.to = {hole, cone.from.y() - width / kDrillPointSlope};
  else
    wall.pop_back();
  bore(moves, std::move(wall), hole, inside);
}

// Returns the depth through the part, plus the point of the drill, and the room of a boring bar (mm) below the part.
double throughDepth(const TargetProfile& target, double hole, double room, double below) {
  const double deep = room + kBesideWall + hole;
  if (deep > below - kBesideWall)
    refuse({}, "bar", "the drill would come out of its lower end in the chuck",
           "Take a bar that is at least " + roundedText(deep - below + kBesideWall, 2) + " mm longer.");
  return target.length() + deep;
}

}  // namespace

Result<BoreTools> boreTools(const TargetProfile& target, double drill, const LatheTools& tools) {
  try {
    return toolsFor(boreWallOf(target), drill, tools);
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
}

bool hasBore(const TargetProfile& target) {
  const Result<TargetSides> sides = sidesOf(target);
  return !sides || std::any_of(sides->bores.begin(), sides->bores.end(), [&](const TargetProfile& bore) {
    return bore.upperEnd() > target.upperEnd() + TargetProfile::kJoin;
  });
}

std::vector<double> drillsFor(const TargetProfile& target, const LatheTools& tools) {
  std::vector<double> diameters;
  for (const auto& tool : tools) {
    const double diameter = 2.0 * tool->reach();
    if (tool->kind == LatheToolKind::Drill && boreTools(target, diameter, tools)) diameters.push_back(diameter);
  }
  std::sort(diameters.rbegin(), diameters.rend());
  return diameters;
}

double drillFor(const TargetProfile& target, const LatheTools& tools) {
  const std::vector<double> diameters = drillsFor(target, tools);
  return diameters.empty() ? 0.0 : diameters.front();
}

// Checks the shape of the bore; then the largest drill that goes into it.
std::optional<Error> whyNoDrill(const TargetProfile& target, const LatheTools& tools) {
  try {
    const BoreWall wall = boreWallOf(target);
    double largest = 0.0, smallest = std::numeric_limits<double>::infinity();
    for (const auto& tool : tools) {
      if (tool->kind != LatheToolKind::Drill) continue;
      smallest = std::min(smallest, tool->reach());
      if (tool->reach() <= wall.leastRadius() + kSameRadius) largest = std::max(largest, tool->reach());
    }
    toolsFor(wall, 2.0 * (largest > 0.0 ? largest : smallest), tools);
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
  return std::nullopt;
}

Result<std::vector<ToolMove>> drillAndBore(const TargetProfile& target, const BoreTools& tools,
                                           const CycleSettings& settings, double below) {
  try {
    const BoreWall wall = boreWallOf(target);
    const double hole = tools.drill->reach();
    const bool isThrough = wall.bottom == BoreWall::Bottom::Through;
    if (!tools.bar)
      return drillTo(isThrough ? throughDepth(target, hole, 0.0, below) : wall.depth, 2.0 * hole, settings);
    const CycleSettings inside = inHole(settings, *tools.bar, below);
    const double room = 2.0 * inside.nose + inside.allowance + inside.overrun;
    const double depth = isThrough                               ? throughDepth(target, hole, room, below)
                         : wall.bottom == BoreWall::Bottom::Flat ? wall.depth - kAboveFlat
                                                                 : wall.depth;
    std::vector<ToolMove> moves = drillTo(depth, 2.0 * hole, settings);
    if (isThrough) bore(moves, wall.wall, hole, inside);
    if (wall.bottom == BoreWall::Bottom::Flat) boreToFlat(moves, wall, hole, inside);
    if (wall.bottom == BoreWall::Bottom::Drilled) boreToCone(moves, wall, hole, inside);
    return moves;
  } catch (const ProgramRefusal& refusal) {
    return refusal.error;
  }
}

}  // namespace handwheel
