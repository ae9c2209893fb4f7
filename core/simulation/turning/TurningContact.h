// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/thread/PartThreads.h"

#include <array>

namespace handwheel {

// The part of a turned profile near the tool, for the servo loop. The simulation renews it. Distances from the axis
// count away from the material of the tool's side: r outside, -r in a bore (sideways()), so that the material is below
// its surface on either side.
struct ProfilePatch {
  static constexpr std::size_t kMost = 512;

  double z = 0.0;        // mm, z of the first sample
  double spacing = 1.0;  // mm, distance from one sample to the next
  double width = 0.0;    // mm, range above its z that each sample represents; 0: exact
  std::uint32_t count = 0;
  std::uint32_t simulation = 0;       // number of its simulation; only another simulation can add material
  double farSide = 0.0;               // mm, distance below which there is free space on the other side of the material
  std::array<double, kMost> radii{};  // mm, surface: the highest value within the width

  // Returns the displacement upwards by which a disc leaves the material, mm. It is at most 0 outside of the material,
  // and 0 beside the patch and on the far side. It is never less than for the full profile. O(samples below the disc).
  double penetration(const ProfilePoint& centre, double radius) const;

  // Returns the width of the chip that a disc takes, mm. It is the width of the material within the disc across the
  // direction of motion. ahead: the unit vector of the motion. O(samples below the disc).
  double chipWidth(const ProfilePoint& centre, double radius, const ProfilePoint& ahead) const;

  // Returns true if a disc is wholly on the far side. The far side of a tool for the outside is in the bore; that of a
  // tool for the bore is around the part.
  bool isOnFarSide(const ProfilePoint& centre, double radius) const { return centre.x() + radius <= farSide; }

 private:
  // Calls visit(surface in mm, distance along z from the centre in mm) for each sample below the disc.
  template <class Visit>
  void forEachBelow(const ProfilePoint& centre, double radius, const Visit& visit) const;
};

// Converts a radius to the coordinate of a patch of a side, and back.
inline double sideways(TurningSide side, double r) {
  return side == TurningSide::Bore ? -r : r;
}

// The threads of a part in the half plane of the hand. The grooves in this half plane shift with its angle, since their
// helix rises.
struct PatchThreads {
  const PartThreads* threads = nullptr;  // null: none
  double angle = 0.0;                    // angle of the half plane about the axis, from +x
};

// Returns the profile around z, far enough for a nose to move by its own radius. If this range has too many samples,
// each entry is the highest surface of several consecutive samples.
ProfilePatch patchAround(const TurnedProfile& profile, double z, double noseRadius,
                         TurningSide side = TurningSide::Outside, const PatchThreads& threads = {});

// The settings of a cutting tool on a lathe. The mm of stiffness and resistance are mm in the scene, not at the device
// (WorkspaceMapping::scale).
struct TurningTool {
  double noseRadius = 1.0;  // mm
  double stiffness = 0.5;   // N/mm, spring between hand and tool
  double resistance = 0.1;  // N·s/mm²: force divided by the speed through material and by the chip width
  TurningSide side = TurningSide::Outside;

  bool operator==(const TurningTool&) const = default;
};

// The god-object of a lathe tool, which follows the hand. The tool moves freely beside the material. While it cuts, it
// goes through the material, more slowly the wider the chip is; otherwise it cannot go deeper into the material.
// Material that comes back around a resting hand, for example by undo, does not push the hand out. Such material is
// felt only if the hand moves further in, and fully once the hand has left it. The same holds for material that the
// hand enters from the far side. All positions are in the half plane of the patch.
class TurningContact {
 public:
  void reset(const ProfilePoint& hand);

  // Advances by one tick of dt seconds. Returns true if the tool is in or on the material.
  bool follow(const ProfilePatch& patch, const TurningTool& tool, const ProfilePoint& hand, bool isCutting, double dt);

  const ProfilePoint& tool() const { return m_tool; }  // centre of the nose

 private:
  ProfilePoint m_tool = ProfilePoint::Zero();
  std::uint32_t m_simulation = 0;  // simulation of the previous patch
  double m_depth = 0.0;            // mm, depth of the hand in the material, as felt
  double m_unfelt = 0.0;           // mm, depth of material that came back around the hand
  bool m_isOnFarSide = false;
};

}  // namespace handwheel
