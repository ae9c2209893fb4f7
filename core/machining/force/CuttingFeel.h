// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingForceModel.h"

namespace handwheel {

// The haptic effects of a cut besides its mean force: wear, vibration and slide resistance.
//
// All effects are bounded, so that the servo loop stays stable. Vibration is a fraction of the force, never reverses
// it, and does not depend on the hand. Friction rises linearly at low speeds, so that the force has no step where the
// hand turns back. Values outside the limits are taken as the nearest limit, and not-a-number as 0. The functions may
// be called on any thread and allocate nothing.
struct CuttingFeel {
  static constexpr double kMostWear = 0.5, kMostVibration = 0.3, kMostFriction = 10.0, kMostDrag = 0.1;
  static constexpr double kMostSwing = 5.0, kLeastCreep = 1.0;

  double wear = 0.0;          // mm, flank wear (VB); 0: sharp
  double vibration = 0.05;    // fraction of the cutting force that oscillates with the spindle
  double largestSwing = 1.0;  // N, limit of the vibration
  double friction = 0.3;      // N, friction of the slides
  double creep = 5.0;         // mm/s, speed below which friction is proportional to the speed
  double drag = 0.002;        // N·s/mm, viscous drag of the slides

  bool operator==(const CuttingFeel&) const = default;
};

// Returns the forces of a worn tool. Wear raises the radial force most: 3.4 times at 0.3 mm, where the cutting force
// has risen by half. The factors are linear between the means of a measured set (16 cuts each with a sharp tool, 0.1 mm
// and 0.3 mm of wear), and extrapolated from the last two means beyond.
CutForces worn(const CutForces& sharp, double wear) noexcept;

// Returns the vibration (N) that is added to a force (N) when the spindle has turned by this angle (rad). It has the
// frequency of the spindle. Between an eighth and a quarter of the rate of the servo loop it fades out, because the
// loop cannot sample a faster oscillation. spindle: the spindle speed, r/min. period: the period of the loop, s.
double vibration(const CuttingFeel& feel, double force, double angle, double spindle, double period) noexcept;

// Returns the resistance of the slides (N) against a speed (mm/s). It is the sum of friction and drag and has the sign
// of the speed.
double slideResistance(const CuttingFeel& feel, double speed) noexcept;
// Returns the steepest slope of slideResistance(), N·s/mm. It is the damping with which the servo loop must remain
// stable.
double steepestDamping(const CuttingFeel& feel) noexcept;

}  // namespace handwheel
