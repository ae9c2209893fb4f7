// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cstdint>
#include <limits>

namespace handwheel {

// State of the device tip in the scene at one tick. It contains everything that a force may depend on, so that a
// recorded sequence of these gives the same forces again.
struct TipState {
  Vec3 position = Vec3::Zero();  // mm: the HIP
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();  // mm/s
  double gripper = 0.0;          // mm or rad, as the device has it
  double time = 0.0;             // s since the loop started
  double period = 0.001;         // s since the tick before; never more than a few nominal periods
  // Limits in the scene, N/mm and N·s/mm: a force with damping B must not be stiffer than stiffnessLimit·(1 -
  // B/dampingLimit), and B must stay below dampingLimit (eq. 2-1 with the period and delay that were measured).
  double stiffnessLimit = std::numeric_limits<double>::infinity();
  double dampingLimit = std::numeric_limits<double>::infinity();
  std::uint32_t buttons = 0;  // bit n: button n is held
  // The tip did not get here by moving: first tick, device reconnected, another mapping. A proxy restarts at the tip.
  bool isRestart = true;
};

// Output of a force source for one tick.
struct ForceOut {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double gripper = 0.0;        // N
  Vec3 proxy = Vec3::Zero();   // mm: displayed position of the tip
  bool isContact = false;
  bool isFresh = true;       // false: nothing new since the last tick; the watchdog counts
  double stiffness = 0.0;    // N/mm: largest |dF/dx| of all that acted, after the limit
  double asked = 0.0;        // stiffness before the limit; not recorded
  bool isSoftened = false;   // stiffness or damping was more before the limit
  bool isHeld = false;       // a point or an edge attracts the tip
  Vec3 held = Vec3::Zero();  // position of that attraction, mm
};

// Computes the force of a scene: contact, snapping, a tool. Created on the window thread with everything it needs; from
// then on it belongs to the servo thread, and is freed on the window thread.
class ForceRenderer {
 public:
  virtual ~ForceRenderer() = default;

  // Computes one tick on the servo thread: no lock, no allocation, no system call. `out` is passed with the proxy at
  // the tip and default values otherwise.
  virtual void tick(const TipState& tip, ForceOut& out) noexcept = 0;

  // Takes over state from the previous source, if there was one. Called once on the servo thread, before the first
  // tick: if an edit made a new source of the same kind, the proxy continues from the old one's. A source that follows
  // none begins at the tip of its first tick, whatever isRestart is. The rules of tick() apply here, too: nothing is
  // freed.
  virtual void follow(const ForceRenderer& previous) noexcept { (void)previous; }
};

}  // namespace handwheel
