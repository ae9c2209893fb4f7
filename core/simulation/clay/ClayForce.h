// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"
#include "simulation/clay/ClayContact.h"
#include "simulation/clay/ClaySimulation.h"

namespace handwheel {

// The id of the force source of clay.
inline constexpr const char* kClaySource = "clay";

// The force of clay on a tool: a spring between hand and god-object. The god-object is the tool, which the clay holds
// back (ClayContact). The force of a drill is the thrust that the simulation computes, with its torque about the axis.
class ClayForce : public ForceSource {
 public:
  ClayForce(std::shared_ptr<ClayChannel> channel, const ClayFeel& feel);

  void follow(const ForceSource& previous) noexcept override;
  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;

  static constexpr double kFullForce = 2.0;  // N, force of full pressure

 private:
  void swing(double period) noexcept;
  double held() const noexcept;

  std::shared_ptr<ClayChannel> m_channel;
  ClayFeel m_feel;
  ClayContact m_contact;
  double m_share = 1.0;        // factor of the stiffness in the previous tick
  Vec3 m_hand = Vec3::Zero();  // mm, foremost point of the tool at the pose of the hand
  double m_angle = 0.0;        // rad, spindle angle
  double m_give = 1.0;         // factor of the stiffness by the vibration
  bool m_isCutting = false;
  bool m_isTouching = false;
  bool m_isPlaced = false;
};

}  // namespace handwheel
