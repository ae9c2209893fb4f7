// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/RemovedMaterial.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Kind of a lathe tool.
enum class LatheToolKind {
  RightTurning,  // cuts towards the chuck
  LeftTurning,
  Facing,
  Parting,
  Grooving,
  Form,
  Threading,
  BoringBar,
  Drill,
  File,
  AbrasivePaper,
  GrindingDisk
};
inline constexpr std::size_t kLatheToolKinds = 12;

std::string_view idOf(LatheToolKind kind);  // "right-turning"
std::optional<LatheToolKind> latheToolKindNamed(std::string_view id);
const char* titleOf(LatheToolKind kind);  // English, context "LatheTool"

// The shape of a lathe tool and how it cuts. The sections are relative to the tip, the point that touching off
// measures: of a turning tool where the tangents of the nose in r and in z meet, of a blade its corner towards the
// chuck, of what is symmetric its innermost, or for a bore its foremost, point. r grows away from the axis, z away from
// the chuck.
struct LatheTool {
  static constexpr std::size_t kMostSections = 8;  // of a cutting part, and of a holder

  std::string id;
  LatheToolKind kind = LatheToolKind::RightTurning;
  std::string designation;  // "CNMG 120408"; not translated
  TurningSide side = TurningSide::Outside;
  double noseRadius = 0.4;  // mm; 0: sharp
  // Where the tip lies from the centre of the nose, in the numbers of ISO and of machine programs: 3 is towards the
  // axis and the chuck, 2 outward and to the chuck, 4 and 1 away from the chuck, 8 straight towards the axis, 6
  // outward, 7 to the chuck, 5 away from it, 9 the centre itself.
  int orientation = 3;
  double enteringAngle = 95.0;  // degrees
  double rake = 0.0;            // degrees
  // What file, paper and grinding disk take off in a turn of the part at most, mm; 0: as deep as it is moved.
  double depthPerTurn = 0.0;
  double leastRoughness = 0.0;  // µm Ra: that no number of passes falls below
  std::vector<RoundedPolygon> cutting;
  std::vector<RoundedPolygon> holder;

  bool isAbrasive() const { return depthPerTurn > 0.0; }
  // From the tip to the centre of the nose, mm.
  ProfilePoint noseCentre() const;
  // The way of the radial force of a cut on this tool, which moves this way: across it, and out of the material that
  // the edge leaves. The shorter, of length 1 at most, the more the edge cuts to both sides, where what pushes it to
  // the one balances the other: a blade that plunges is pushed back only, by the feed force. A way of no length: none.
  ProfilePoint passiveWay(const ProfilePoint& way) const;
  double width() const;  // mm, of the cutting part along z
  double reach() const;  // mm, of the cutting part beyond its tip in r: of a drill its radius

  bool operator==(const LatheTool&) const = default;
};

// Tools of a lathe with their names in the file.
using LatheTools = std::vector<std::shared_ptr<const LatheTool>>;

// The tool of this id; null: none.
std::shared_ptr<const LatheTool> toolNamed(const LatheTools& tools, std::string_view id);

// What a tool removes with its tip moving straight from one place to another. Places that are not finite: nothing.
RemovedMaterial cutWithTool(TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                            const ProfilePoint& to);
RemovedMaterial previewCut(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                           const ProfilePoint& to);

// The samples that such a cut visits, those of all sections together.
std::size_t samplesUnderTool(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                             const ProfilePoint& to);

}  // namespace handwheel
