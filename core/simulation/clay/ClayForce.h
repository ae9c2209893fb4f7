// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/scene/ForceSource.h"
#include "simulation/clay/ClayContact.h"
#include "simulation/clay/ClaySimulation.h"

namespace handwheel {

// The id of the force source.
inline constexpr const char* kClaySource = "clay";

// The force of clay on a tool: a spring between hand and god-object. The clay holds back the latter, which is the tool
// (ClayContact). Of a drill it is the thrust that the simulation computes, with its torque about the axis.
class ClayForce : public ForceSource {
 public:
  ClayForce(std::shared_ptr<ClayChannel> channel, const ClayFeel& feel);

  void follow(const ForceSource& previous) noexcept override;
  ForceBounds advance(const TipState& tip, ForceOut& out) noexcept override;
  Vec3 force(const TipState& tip, double stiffness, double damping) noexcept override;

  static constexpr double kFullForce = 2.0;  // N, of a hand that presses fully: a share of it is the pressure

 private:
  void swing(double period) noexcept;
  double held() const noexcept;

  std::shared_ptr<ClayChannel> m_channel;
  ClayFeel m_feel;
  ClayContact m_contact;
  double m_share = 1.0;        // of the stiffness, in the tick before
  Vec3 m_hand = Vec3::Zero();  // mm, of the tool's foremost point, as the hand has it
  double m_angle = 0.0;        // radian, that the spindle has turned by
  double m_give = 1.0;         // what the vibration leaves of the spring
  bool m_isCutting = false;
  bool m_isTouching = false;
  bool m_isPlaced = false;
};

}  // namespace handwheel
