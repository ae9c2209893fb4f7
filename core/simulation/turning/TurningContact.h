// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"

#include <array>

namespace handwheel {

// The part of a turned profile near the tool: what the servo loop knows of it. The simulation renews it.
struct ProfilePatch {
  static constexpr std::size_t kMost = 256;

  double z = 0.0;        // mm, of the first sample
  double spacing = 1.0;  // mm
  double bottom = 0.0;   // mm: no material of the part below this z
  double top = 0.0;      // and none above this one
  std::uint32_t count = 0;
  std::array<double, kMost> radii{};  // mm

  // How far a disc around (r, z) must move away from the axis to leave the material; at most 0 outside of it. mm.
  // Beside the patch there is none. O(samples below the disc).
  double penetration(const ProfilePoint& centre, double radius) const;
};

// The samples around z, so many that a nose of this radius can move by as much again; fewer where they are many.
ProfilePatch patchAround(const TurnedProfile& profile, double z, double noseRadius);

// The settings of a cutting tool on a lathe. Stiffness and damping are those in the scene.
struct TurningTool {
  double noseRadius = 1.0;  // mm
  double stiffness = 0.5;   // N/mm, of the spring between hand and tool
  double resistance = 0.1;  // N·s/mm: force by the speed at which it goes through material

  bool operator==(const TurningTool&) const = default;
};

// The tool of a lathe, which follows the hand: freely beside the material, slowly through it while it cuts, and never
// into it otherwise. All in the half plane (r, z).
class TurningContact {
 public:
  void place(const ProfilePoint& hand) { m_tool = hand; }

  // One tick of dt seconds. Returns whether the tool is in or on the material.
  bool follow(const ProfilePatch& patch, const TurningTool& tool, const ProfilePoint& hand, bool isCutting, double dt);

  const ProfilePoint& tool() const { return m_tool; }  // centre of the nose

 private:
  ProfilePoint m_tool = ProfilePoint::Zero();
};

}  // namespace handwheel
