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

  double z = 0.0;        // mm, of the first sample
  double spacing = 1.0;  // mm, from one to the next
  double width = 0.0;    // mm: each stands for the profile from its z on over this length; 0: exact
  std::uint32_t count = 0;
  std::uint32_t simulation = 0;       // number of that which wrote it: in another one the profile may have grown
  double farSide = 0.0;               // mm: what lies below this is no material, but free space on the other side
  std::array<double, kMost> radii{};  // mm, of the surface: the highest over the width

  // How far a disc must move up to leave the material; at most 0 outside of it. mm. Never less than the samples of the
  // profile would have it. Beside the patch and on the far side there is none. O(samples below the disc).
  double penetration(const ProfilePoint& centre, double radius) const;

  // The width of the chip that a disc takes where it goes, mm: of the material within the disc, across its way.
  // O(samples below the disc). ahead: unit vector.
  double chipWidth(const ProfilePoint& centre, double radius, const ProfilePoint& ahead) const;

  // Whether a disc is wholly on the far side: in the bore with a tool for the outside, or around the part with one for
  // the bore.
  bool isOnFarSide(const ProfilePoint& centre, double radius) const { return centre.x() + radius <= farSide; }

 private:
  // visit(mm, of the surface; mm, along z from the centre), for each sample below the disc.
  template <class Visit>
  void forEachBelow(const ProfilePoint& centre, double radius, const Visit& visit) const;
};

// A distance from the axis as a patch of this side counts it, and back.
inline double sideways(TurningSide side, double r) {
  return side == TurningSide::Bore ? -r : r;
}

// The half plane of a part in which the hand is: its threads as grooves there, which rise with the angle as their
// helix.
struct PatchThreads {
  const PartThreads* threads = nullptr;  // null: none
  double angle = 0.0;                    // about the axis, from +x
};

// The profile around z, so far that a nose of this radius can move by as much again. Where that has too many samples,
// the highest surface of several that follow one another is taken.
ProfilePatch patchAround(const TurnedProfile& profile, double z, double noseRadius,
                         TurningSide side = TurningSide::Outside, const PatchThreads& threads = {});

// The settings of a cutting tool on a lathe. Stiffness and damping are those in the scene.
struct TurningTool {
  double noseRadius = 1.0;  // mm
  double stiffness = 0.5;   // N/mm, of the spring between hand and tool
  double resistance =
      0.1;  // N·s/mm², of a chip: force by the speed at which it goes through material, and by its width
  TurningSide side = TurningSide::Outside;

  bool operator==(const TurningTool&) const = default;
};

// The god-object of a lathe tool, which follows the hand. It moves freely beside the material, through it while it cuts
// the more slowly the wider the chip is, and no deeper into it otherwise. Material that comes back around a resting
// hand, as by undo, does not push it out: it is felt from there on inward, and whole once the hand has left it; so is
// material that the hand comes into from the far side. All in the half plane of the patch.
class TurningContact {
 public:
  void place(const ProfilePoint& hand);

  // One tick of dt seconds. Returns whether the tool is in or on the material.
  bool follow(const ProfilePatch& patch, const TurningTool& tool, const ProfilePoint& hand, bool isCutting, double dt);

  const ProfilePoint& tool() const { return m_tool; }  // centre of the nose

 private:
  ProfilePoint m_tool = ProfilePoint::Zero();
  std::uint32_t m_simulation = 0;  // of the patch before
  double m_depth = 0.0;            // mm: how deep the hand was felt to be in the material
  double m_unfelt = 0.0;           // mm: how deep the material came back around it
  bool m_isOnFarSide = false;
};

}  // namespace handwheel
