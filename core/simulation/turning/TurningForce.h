// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"
#include "simulation/Simulation.h"
#include "simulation/turning/TurningContact.h"

namespace handwheel {

using TurningChannel = SimulationChannel<ProfilePatch>;

// The id of the force source.
inline constexpr const char* kTurningSource = "turning";

// The force of a cutting tool on a turning part. It is a spring between the hand and the tool, which goes through
// material only as fast as it is pressed, F = resistance · speed, also where the loop can carry a softer spring only.
// In a gesture it cuts; otherwise the part is felt as it is. The part turns about z from z = base on, and is felt alike
// from all sides.
class TurningForce : public ForceSource {
 public:
  TurningForce(std::shared_ptr<TurningChannel> channel, const TurningTool& tool, double base);

  void follow(const ForceSource& previous) noexcept override;
  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;

 private:
  std::shared_ptr<TurningChannel> m_channel;
  TurningTool m_tool;
  double m_base;  // mm
  TurningContact m_contact;
  Vec3 m_outward = Vec3::UnitX();  // from the axis to the hand
  Vec3 m_proxy = Vec3::Zero();
  double m_share = 1.0;  // of the stiffness, in the tick before: that of a tick is known after its advance()
  bool m_isTouching = false;
  bool m_isPlaced = false;
};

}  // namespace handwheel
