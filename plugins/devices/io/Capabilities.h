// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Estimates the inherent damping b of a device, N·s/mm, from its stated stiffness K. Manufacturers do not publish b.
// But a wall of K (N/mm) in a loop of that rate (Hz) and delay (s, from a position to the force for it) is passive only
// with b = K·(T/2 + t) at least (eq. 2-1; with a delay Gil et al., JCISE 9(1), 2009). The delay is that of the program
// for which K is stated, never ours: the additional delay of ours makes walls softer.
constexpr double inherentDampingFor(double stiffness, double rate, double delay) {
  return stiffness * (0.5 / rate + delay);
}

// Delay that ThreadedDevice adds, s. The force for a reading misses the exchange that begins as the reading comes in,
// and waits for the next.
inline constexpr double kHandOver = 0.001;

}  // namespace handwheel
