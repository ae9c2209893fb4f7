// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheCollisions.h"

#include "base/Translatable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kWorkTolerance = 0.02;  // mm; a holder may be beside a flank that leans between samples of the profile

LatheSolid boxOf(LathePart part, double leastR, double largestR, double first, double last) {
  const std::array<ProfilePoint, 4> corners{{{leastR, first}, {leastR, last}, {largestR, last}, {largestR, first}}};
  return {part, RoundedPolygon(corners, 0.0)};
}

// Returns the section of a dead centre: 60°.
LatheSolid centreOf(double tip) {
  constexpr double kRadius = 10.0, kShank = 12.0;
  const double back = tip + kRadius / std::tan(M_PI / 6.0);
  const std::array<ProfilePoint, 5> corners{
      {{0.0, tip}, {kRadius, back}, {-kRadius, back}, {kRadius, back + kShank}, {-kRadius, back + kShank}}};
  return {LathePart::Fitting, RoundedPolygon(corners, 0.0)};
}

double lastOf(const std::vector<RoundedPolygon>& sections) {
  double last = 0.0;
  for (const RoundedPolygon& section : sections) {
    for (const ProfilePoint& p : section.corners()) last = std::max(last, p.y() + section.radius());
  }
  return last;
}

bool isHeldByHand(LatheToolKind kind) {
  return kind == LatheToolKind::File || kind == LatheToolKind::AbrasivePaper;
}

}  // namespace

const char* titleOf(LathePart part) {
  static constexpr std::array<const char*, kLatheParts> kTitles{
      translatable("LathePart", "Cutting edge"), translatable("LathePart", "Tool holder"),
      translatable("LathePart", "Tool post"),    translatable("LathePart", "Compound slide"),
      translatable("LathePart", "Quill"),        translatable("LathePart", "Tailstock"),
      translatable("LathePart", "Jaws"),         translatable("LathePart", "Chuck"),
      translatable("LathePart", "Workpiece")};
  return kTitles[static_cast<std::size_t>(part)];
}

const char* sentenceOf(CrashCause cause) {
  switch (cause) {
    case CrashCause::Contact:
      return translatable("LathePart", "These parts must not touch.");
    case CrashCause::Rapid:
      return translatable("LathePart", "The rapid traverse ran into the workpiece.");
    case CrashCause::SpindleAtRest:
      return translatable("LathePart", "The spindle was at rest.");
    case CrashCause::Reversed:
      return translatable("LathePart", "The spindle turned backwards.");
    case CrashCause::TooDeep:
      return translatable("LathePart", "The cut was deeper than the cutting edge is long.");
    case CrashCause::Overload:
      return translatable("LathePart", "The cut needed more power than the motor has.");
  }
  return "";
}

double grippedRadius(const TurnedProfile& profile, const LatheChuck& chuck) {
  const TurnedProfile::Range held = samplesWithin(profile, 0.0, chuck.grip);
  double radius = chuck.gripsInside ? profile.radius(0) : 0.0;
  for (std::size_t i = held.first; i < held.last; ++i)
    radius = chuck.gripsInside ? std::min(radius, profile.inner(i)) : std::max(radius, profile.radius(i));
  return radius;
}

std::vector<LatheSolid> chuckSolids(const LatheChuck& chuck, double gripped) {
  const double face = chuck.grip - chuck.jawLength;
  const double inner = chuck.gripsInside ? std::max(0.0, gripped - chuck.jawHeight) : gripped;
  const double outer = chuck.gripsInside ? gripped : gripped + chuck.jawHeight;
  return {boxOf(LathePart::Chuck, -0.5 * chuck.diameter, 0.5 * chuck.diameter, face - chuck.length, face),
          boxOf(LathePart::Jaws, inner, outer, face, chuck.grip),
          boxOf(LathePart::Jaws, -outer, -inner, face, chuck.grip)};
}

std::vector<LatheSolid> tailstockSolids(const LatheTailstock& tailstock, double quillTip, const LatheTool* drill) {
  constexpr double kCentre = 30.0, kBehind = 60.0, kBody = 150.0;  // mm along z
  std::vector<LatheSolid> solids;
  if (!tailstock.isUsed()) return solids;
  double quill = quillTip + kCentre;
  if (tailstock.fitting == LatheFitting::Drill && drill) {
    for (const RoundedPolygon& section : drill->cutting)
      solids.push_back({LathePart::CuttingEdge, section.moved({0.0, quillTip})});
    for (const RoundedPolygon& section : drill->holder)
      solids.push_back({LathePart::Fitting, section.moved({0.0, quillTip})});
    quill = quillTip + lastOf(drill->holder);
  } else {
    solids.push_back(centreOf(quillTip));
  }
  const double front = tailstock.position + (quill - quillTip) + kBehind;
  const double radius = 0.5 * tailstock.quillDiameter;
  solids.push_back(boxOf(LathePart::Fitting, -radius, radius, quill, front));
  solids.push_back(boxOf(LathePart::Tailstock, -tailstock.bodyRadius, tailstock.bodyRadius, front, front + kBody));
  return solids;
}

std::vector<LatheSolid> toolSolids(const LatheTool& tool) {
  std::vector<LatheSolid> solids;
  for (const RoundedPolygon& section : tool.cutting) solids.push_back({LathePart::CuttingEdge, section});
  for (const RoundedPolygon& section : tool.holder) solids.push_back({LathePart::Holder, section});
  if (isHeldByHand(tool.kind) || tool.kind == LatheToolKind::Drill) return solids;
  if (tool.side == TurningSide::Bore) {
    const double back = lastOf(tool.holder);
    solids.push_back(boxOf(LathePart::ToolPost, -50.0, 50.0, back, back + 80.0));
  } else {
    solids.push_back(boxOf(LathePart::ToolPost, 80.0, 180.0, -40.0, 40.0));
    solids.push_back(boxOf(LathePart::Slide, 70.0, 200.0, -45.0, 60.0));
  }
  return solids;
}

std::optional<LatheCollision> contactBetween(const std::vector<LatheSolid>& moved, const ProfilePoint& at,
                                             const std::vector<LatheSolid>& others) {
  for (const LatheSolid& solid : moved) {
    const RoundedPolygon here = solid.section.moved(at);
    for (const LatheSolid& other : others) {
      if (distanceBetween(here, other.section) > 0.0) continue;
      LatheCollision collision;
      collision.moving = solid.part;
      collision.struck = other.part;
      collision.position = at;
      return collision;
    }
  }
  return std::nullopt;
}

std::optional<LatheCollision> contactWithWork(const std::vector<LatheSolid>& moved, const ProfilePoint& from,
                                              const ProfilePoint& to, const TurnedProfile& work, double within) {
  for (const LatheSolid& solid : moved) {
    if (solid.part == LathePart::CuttingEdge) continue;
    const SectionOverlap overlap = overlapOf(work, SectionSweep(solid.section, from, to), within);
    if (!(overlap.depth > kWorkTolerance)) continue;
    LatheCollision collision;
    collision.moving = solid.part;
    collision.position = overlap.position;
    collision.depth = overlap.depth;
    return collision;
  }
  return std::nullopt;
}

}  // namespace handwheel
