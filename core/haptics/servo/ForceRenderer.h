// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cstdint>
#include <limits>

namespace handwheel {

// State of the device tip in the scene at one tick. It contains everything on which a force may depend, so that a
// recorded sequence of states reproduces the forces.
struct TipState {
  Vec3 position = Vec3::Zero();  // position of the device tip, mm
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();  // mm/s
  double gripper = 0.0;          // mm or rad, depending on the device
  double time = 0.0;             // s since the loop started
  double period = 0.001;         // s since the previous tick; never more than a few nominal periods
  // Limits in the scene, N/mm and N·s/mm. The stiffness of a force with damping B must not exceed stiffnessLimit·(1 -
  // B/dampingLimit), and B must be less than dampingLimit (He 2008, eq. 2-1, with the measured period and delay).
  double stiffnessLimit = std::numeric_limits<double>::infinity();
  double dampingLimit = std::numeric_limits<double>::infinity();
  std::uint32_t buttons = 0;  // bit n: button n is held
  // True if the tip did not move continuously to its position: first tick, device reconnected, another mapping. A proxy
  // restarts at the tip.
  bool isRestart = true;
};

// Output of a force source for one tick.
struct ForceOut {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double gripper = 0.0;        // N
  Vec3 proxy = Vec3::Zero();   // displayed position of the tip, mm
  bool isContact = false;
  bool isFresh = true;       // false: nothing is new since the last tick, and the watchdog counts the tick
  double stiffness = 0.0;    // N/mm: largest |dF/dx| of all active forces, after the limit
  double asked = 0.0;        // N/mm: stiffness before the limit; not recorded
  bool isSoftened = false;   // true: the stiffness or damping was larger before the limit
  bool isHeld = false;       // true: a point or an edge attracts the tip
  Vec3 held = Vec3::Zero();  // position of the attracting point, mm
};

// Computes the force of a scene: contact, snapping, a tool. A renderer is created on the window thread with all its
// data. It then belongs to the servo thread, and is finally freed on the window thread.
class ForceRenderer {
 public:
  virtual ~ForceRenderer() = default;

  // Computes one tick. It is called on the servo thread, and must not lock, allocate or make system calls. out: has the
  // proxy at the tip, and default values otherwise.
  virtual void tick(const TipState& tip, ForceOut& out) noexcept = 0;

  // Takes over state from the previous renderer, if there is one. It is called once on the servo thread, before the
  // first tick: if an edit created a new renderer of the same kind, the proxy continues from that of the old one. A
  // renderer that follows none begins at the tip of its first tick, regardless of isRestart. It must not lock,
  // allocate, free or make system calls.
  virtual void follow(const ForceRenderer& previous) noexcept { (void)previous; }
};

}  // namespace handwheel
