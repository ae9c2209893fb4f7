// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"
#include "machining/force/CuttingFeel.h"
#include "simulation/turning/LatheSimulation.h"

namespace handwheel {

// The id of the force source of the lathe.
inline constexpr const char* kLatheSource = "lathe";

// Settings of the forces of a lathe on the hand. The mm of stiffnesses are mm in the scene, not at the device
// (WorkspaceMapping::scale).
struct LatheTouch {
  double stiffness = 0.5;    // N/mm, spring between the hand and the tool that it holds
  double plane = 0.3;        // N/mm, attraction of the work plane
  double planeReach = 8.0;   // mm, range of the attraction of the work plane
  double forceShare = 0.01;  // factor of the cutting force, which is far beyond the force of a device
  double mostForce = 4.0;    // N, limit of the scaled cutting force
  CuttingFeel feel;

  bool operator==(const LatheTouch&) const = default;
};

// The force of a manual lathe. A plane through the axis, y = 0, attracts the hand. A spring connects the hand and the
// tool that it holds in a gesture, in the distance at which it took it, since the slides move only as fast as the
// machine allows. While the tool cuts, the
// force of the cutting law, or the pressure of an abrasive, pushes it along with the work, back, and out of the
// material; the slides have friction and drag. A hand that holds no tool feels the part from outside, and the grooves
// of its threads while the part does not turn. A tick allocates no memory and takes no lock.
class LatheForce : public ForceSource {
 public:
  // material: the cutting data of the material for the tools of the simulation; never null. base: z of the part's lower
  // end in the scene, mm.
  LatheForce(std::shared_ptr<LatheChannel> channel, std::shared_ptr<const LatheMaterial> material,
             const LatheTouch& touch, double base);

  void follow(const ForceSource& previous) noexcept override;
  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;

  // Returns the cutting forces of the last tick according to the cutting law, N, without the factor
  // LatheTouch::forceShare.
  const CutForces& cut() const { return m_cut; }

 private:
  void touch(const TipState& tip, ForceOut& out) noexcept;
  double planeForce(double y) const noexcept;
  Vec3 cutForce(double period) const noexcept;

  std::shared_ptr<LatheChannel> m_channel;
  std::shared_ptr<const LatheMaterial> m_material;
  LatheTouch m_touch;
  double m_base;
  LathePatch m_patch;
  CutForces m_cut;
  ProfilePoint m_press{0.0, 0.0};  // N, force on an abrasive in (r, z)
  Vec3 m_hold = Vec3::Zero();      // mm, position of the hand that the tool corresponds to
  bool m_isHeld = false;
  TurningContact m_contact;        // contact of a hand that holds no tool
  Vec3 m_outward = Vec3::UnitX();  // direction from the axis to that hand
  Vec3 m_surface = Vec3::Zero();   // mm, point of the part that holds the hand
  bool m_isTouching = false;
  bool m_wasFree = false;  // the hand held no tool in the previous tick
};

}  // namespace handwheel
