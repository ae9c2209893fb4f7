// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheTool.h"

#include "base/Translatable.h"

#include <algorithm>
#include <array>

namespace handwheel {

namespace {

struct KindName {
  const char* id;
  const char* title;
};

constexpr std::array<KindName, kLatheToolKinds> kKindNames{{
    {"right-turning", translatable("LatheTool", "Turning tool, right")},
    {"left-turning", translatable("LatheTool", "Turning tool, left")},
    {"facing", translatable("LatheTool", "Facing tool")},
    {"parting", translatable("LatheTool", "Parting tool")},
    {"grooving", translatable("LatheTool", "Grooving tool")},
    {"form", translatable("LatheTool", "Form tool")},
    {"threading", translatable("LatheTool", "Threading tool")},
    {"boring-bar", translatable("LatheTool", "Boring bar")},
    {"drill", translatable("LatheTool", "Drill")},
    {"file", translatable("LatheTool", "File")},
    {"abrasive-paper", translatable("LatheTool", "Abrasive paper")},
    {"grinding-disk", translatable("LatheTool", "Grinding disk")},
}};

// Directions in r and z, by orientation.
constexpr std::array<std::array<int, 2>, 10> kTipFromNose{
    {{0, 0}, {1, 1}, {1, -1}, {-1, -1}, {-1, 1}, {0, 1}, {1, 0}, {0, -1}, {-1, 0}, {0, 0}}};

}  // namespace

std::string_view idOf(LatheToolKind kind) {
  return kKindNames[static_cast<std::size_t>(kind)].id;
}

std::optional<LatheToolKind> latheToolKindNamed(std::string_view id) {
  for (std::size_t i = 0; i < kKindNames.size(); ++i) {
    if (kKindNames[i].id == id) return static_cast<LatheToolKind>(i);
  }
  return std::nullopt;
}

const char* titleOf(LatheToolKind kind) {
  return kKindNames[static_cast<std::size_t>(kind)].title;
}

ProfilePoint LatheTool::noseCentre() const {
  const auto& towards = kTipFromNose[static_cast<std::size_t>(std::clamp(orientation, 1, 9))];
  return {-noseRadius * towards[0], -noseRadius * towards[1]};
}

// For a corner between two edges this is 1 along either of them.
ProfilePoint LatheTool::passiveDirection(const ProfilePoint& direction) const {
  const double length = direction.norm();
  if (!(length > 0.0) || kind == LatheToolKind::Drill) return ProfilePoint::Zero();
  const auto& tip = kTipFromNose[static_cast<std::size_t>(std::clamp(orientation, 1, 9))];
  ProfilePoint out(-tip[0], -tip[1]);
  const bool isBlade = kind == LatheToolKind::Parting || kind == LatheToolKind::Grooving;
  if (isBlade || out.isZero()) out = {side == TurningSide::Bore ? -1.0 : 1.0, 0.0};
  const ProfilePoint ahead = direction / length, across = out - out.dot(ahead) * ahead;
  return across / std::max(1.0, across.norm());
}

double LatheTool::width() const {
  double least = 0.0, largest = 0.0;
  for (const RoundedPolygon& section : cutting) {
    for (const ProfilePoint& p : section.corners()) {
      least = std::min(least, p.y() - section.radius());
      largest = std::max(largest, p.y() + section.radius());
    }
  }
  return largest - least;
}

double LatheTool::reach() const {
  double largest = 0.0;
  for (const RoundedPolygon& section : cutting) {
    for (const ProfilePoint& p : section.corners()) largest = std::max(largest, p.x() + section.radius());
  }
  return largest;
}

std::shared_ptr<const LatheTool> toolNamed(const LatheTools& tools, std::string_view id) {
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const auto& tool) { return tool->id == id; });
  return found == tools.end() ? nullptr : *found;
}

RemovedMaterial cutWithTool(TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                            const ProfilePoint& to) {
  RemovedMaterial cut;
  for (const RoundedPolygon& section : tool.cutting)
    cut.add(cutSection(profile, SectionSweep(section, from, to), tool.side));
  return cut;
}

// If sections of a tool overlap, the removed material is counted for each of them.
RemovedMaterial previewCut(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                           const ProfilePoint& to) {
  RemovedMaterial cut;
  for (const RoundedPolygon& section : tool.cutting)
    cut.add(previewCut(profile, SectionSweep(section, from, to), tool.side));
  return cut;
}

std::size_t samplesUnderTool(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                             const ProfilePoint& to) {
  std::size_t sum = 0;
  for (const RoundedPolygon& section : tool.cutting) {
    const SectionSweep sweep(section, from, to);
    if (!sweep.empty()) sum += samplesWithin(profile, sweep.first(), sweep.last()).size();
  }
  return sum;
}

}  // namespace handwheel
