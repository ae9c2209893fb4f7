// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <cstdint>
#include <limits>

namespace handwheel {

// The tip of the device in the scene at one tick: everything that a force may depend on, so that a recorded sequence of
// these gives the same forces again.
struct TipState {
  Vec3 position = Vec3::Zero();  // mm: the HIP
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  Vec3 velocity = Vec3::Zero();  // mm/s
  double gripper = 0.0;          // mm or rad, as the device has it
  double time = 0.0;             // s since the loop started
  double period = 0.001;         // s since the tick before; never more than a few nominal periods
  // N/mm and N·s/mm, as they are in the scene: what acts with a damping B must not be stiffer than
  // stiffnessLimit·(1 - B/dampingLimit), and B must stay below (eq. 2-1 with the period and delay that were measured).
  double stiffnessLimit = std::numeric_limits<double>::infinity();
  double dampingLimit = std::numeric_limits<double>::infinity();
  std::uint32_t buttons = 0;  // bit n: button n is held
  // The tip did not come here by moving: first tick, device back, another mapping. A proxy starts anew at the tip.
  bool isRestart = true;
};

// What is felt at one tick.
struct ForceOut {
  Vec3 force = Vec3::Zero();   // N
  Vec3 torque = Vec3::Zero();  // N·mm
  double gripper = 0.0;        // N
  Vec3 proxy = Vec3::Zero();   // mm: where the tip is shown
  bool isContact = false;
  bool isFresh = true;       // false: nothing new is known since the last tick; the watchdog counts
  double stiffness = 0.0;    // N/mm: largest |dF/dx| of all that acted, after the limit
  bool isSoftened = false;   // it was more before the limit
  bool isHeld = false;       // a point or an edge draws the tip,
  Vec3 held = Vec3::Zero();  // to here; mm
};

// Makes the force of a scene: contact, snapping, a tool. Built on the window thread with everything it needs; from then
// on it belongs to the servo thread, and is freed on the window thread.
class ForceSource {
 public:
  virtual ~ForceSource() = default;

  // One tick on the servo thread: no lock, no allocation, no system call. `out` comes with proxy at the tip and the
  // rest as above.
  virtual void tick(const TipState& tip, ForceOut& out) noexcept = 0;

  // Called on the servo thread once, before the first tick, with the source that acted so far if there was one: where
  // an edit made a new one of the same kind, the proxy goes on from the old one's. A source that follows none begins at
  // the tip of its first tick, whatever isRestart says. The rules of a tick hold here, too: nothing is freed.
  virtual void follow(const ForceSource& previous) noexcept { (void)previous; }
};

}  // namespace handwheel
