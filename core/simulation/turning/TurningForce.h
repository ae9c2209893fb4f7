// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"
#include "simulation/Simulation.h"
#include "simulation/turning/TurningContact.h"

namespace handwheel {

using TurningChannel = SimulationChannel<ProfilePatch>;

// The id of the force source of turning.
inline constexpr const char* kTurningSource = "turning";

// The force of a cutting tool on a turning part. It is a spring between the hand and the tool, which goes through
// material with a speed of force / resistance, even if the servo loop only allows a softer spring. In a gesture the
// tool cuts; otherwise it feels the present part. The part turns about z, has its lower end at z = base, and feels the
// same from all sides.
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
  Vec3 m_outward = Vec3::UnitX();  // direction from the axis to the hand
  Vec3 m_proxy = Vec3::Zero();
  // factor of the stiffness in the previous tick; that of the present tick is known after advance()
  double m_share = 1.0;
  bool m_isTouching = false;
  bool m_isPlaced = false;
};

}  // namespace handwheel
