// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/lathe/RemovedMaterial.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// The kind of a lathe tool.
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
const char* titleOf(LatheToolKind kind);  // English text, translated in the context "LatheTool"

// The shape of a lathe tool and its cutting properties. The sections are relative to the tip, the point that touching
// off measures. The tip of a turning tool is the intersection of the tangents of the nose in r and in z. The tip of a
// blade is its corner towards the chuck; the tip of a symmetric tool is its innermost point, or in a bore its foremost
// point. r grows away from the axis, z away from the chuck.
struct LatheTool {
  static constexpr std::size_t kMostSections = 8;  // limit for the cutting part, and for the holder

  std::string id;
  LatheToolKind kind = LatheToolKind::RightTurning;
  std::string designation;  // "CNMG 120408"; not translated
  TurningSide side = TurningSide::Outside;
  double noseRadius = 0.4;  // mm; 0: sharp
  // Direction of the tip from the centre of the nose, in the numbers of ISO and of machine programs: 3 is towards the
  // axis and the chuck, 2 outward and towards the chuck, 4 towards the axis and away from the chuck, 1 outward and away
  // from the chuck, 8 towards the axis, 6 outward, 7 towards the chuck, 5 away from the chuck, and 9 the centre itself.
  int orientation = 3;
  double enteringAngle = 95.0;  // degrees
  double rake = 0.0;            // degrees
  // Largest depth that a file, paper or grinding disk removes in a turn of the part, mm; 0: the tool cuts as deep as it
  // is moved.
  double depthPerTurn = 0.0;
  double leastRoughness = 0.0;  // µm Ra; limit that no number of passes falls below
  std::vector<RoundedPolygon> cutting;
  std::vector<RoundedPolygon> holder;

  bool isAbrasive() const { return depthPerTurn > 0.0; }
  // Returns the vector from the tip to the centre of the nose, mm.
  ProfilePoint noseCentre() const;
  // Returns the direction of the radial force of a cut on a tool that moves in this direction. It is perpendicular to
  // the motion and points out of the material that remains. Its length is at most 1, and shorter if the edge cuts on
  // both sides, because the forces on the two sides balance. A blade that plunges is pushed back by the feed force
  // only. If `direction` has no length, the result is zero.
  ProfilePoint passiveDirection(const ProfilePoint& direction) const;
  double width() const;  // mm, width of the cutting part along z
  double reach() const;  // mm, extent of the cutting part beyond its tip in r; for a drill its radius

  bool operator==(const LatheTool&) const = default;
};

// The tools of a lathe in the order of their file.
using LatheTools = std::vector<std::shared_ptr<const LatheTool>>;

// Returns the tool with this id, or null if there is none.
std::shared_ptr<const LatheTool> toolNamed(const LatheTools& tools, std::string_view id);

// Removes the material that a tool sweeps while its tip moves straight between two positions. Positions that are not
// finite remove nothing.
RemovedMaterial cutWithTool(TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                            const ProfilePoint& to);
RemovedMaterial previewCut(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                           const ProfilePoint& to);

// Returns the number of samples that cutWithTool() visits, the sum for all sections.
std::size_t samplesUnderTool(const TurnedProfile& profile, const LatheTool& tool, const ProfilePoint& from,
                             const ProfilePoint& to);

}  // namespace handwheel
