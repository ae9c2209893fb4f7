// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingForceModel.h"

namespace handwheel {

// The haptic effects of a cut besides its mean force: wear, vibration, slide resistance.
//
// All effects are bounded, so that the loop stays stable: vibration is a share of the force, never reverses it, and
// does not depend on the hand; friction rises linearly at first, so that the force has no step where the hand turns
// back. Values outside these limits are taken as the nearest one, not-a-number as 0. Functions: any thread, no
// allocation.
struct CuttingFeel {
  static constexpr double kMostWear = 0.5, kMostVibration = 0.3, kMostFriction = 10.0, kMostDrag = 0.1;
  static constexpr double kMostSwing = 5.0, kLeastCreep = 1.0;

  double wear = 0.0;          // mm, flank wear (VB); 0: sharp
  double vibration = 0.05;    // share of the cutting force that oscillates with the spindle
  double largestSwing = 1.0;  // N, limit of the vibration
  double friction = 0.3;      // N, friction of the slides
  double creep = 5.0;         // mm/s: below this speed friction is proportional to it
  double drag = 0.002;        // N·s/mm, viscous drag of the slides

  bool operator==(const CuttingFeel&) const = default;
};

// Returns the forces with a worn tool. Wear raises the radial force first: 3.4 times at 0.3 mm, where the cutting force
// has risen by half. Linear between the means of a measured set (16 cuts each, sharp, 0.1 mm and 0.3 mm), and
// extrapolated from the last two beyond.
CutForces worn(const CutForces& sharp, double wear) noexcept;

// Returns the vibration, N, that is added to a force (N) when the spindle has turned by this angle (radian). It has the
// frequency of the spindle; it fades out from an eighth to a quarter of the rate of the servo loop, where an
// oscillation could not be sampled. spindle: r/min; period: s, period of the loop.
double vibration(const CuttingFeel& feel, double force, double angle, double spindle, double period) noexcept;

// Returns the resistance of the slides, N, against a speed (mm/s): friction and drag, with the sign of the speed.
double slideResistance(const CuttingFeel& feel, double speed) noexcept;
// Returns the steepest slope of slideResistance(), N·s/mm: the damping that the servo loop must be able to bear.
double steepestDamping(const CuttingFeel& feel) noexcept;

}  // namespace handwheel
