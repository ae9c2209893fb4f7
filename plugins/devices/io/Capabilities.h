// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Estimates the inherent damping b of a device, N·s/mm, from its stated stiffness K. Manufacturers do not publish b.
// However, a wall of stiffness K (N/mm) in a loop with period T = 1 / rate (rate in Hz) and delay t (s, from a position
// to the force for it) is passive only if b is at least K·(T/2 + t) (He 2008, eq. 2-1; with a delay Gil et al., JCISE
// 9(1), 2009). The delay must be that of the program for which K is stated, not that of Handwheel, whose additional
// delay makes walls softer.
constexpr double inherentDampingFor(double stiffness, double rate, double delay) {
  return stiffness * (0.5 / rate + delay);
}

// Delay that ThreadedDevice adds, s. The force for a reading misses the exchange that begins when the reading arrives,
// and waits for the next one.
inline constexpr double kHandOver = 0.001;

}  // namespace handwheel
