// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Measured timing of the servo loop, and the damping of the device. Seconds and N·s/mm.
struct ServoTiming {
  double period = 0.001;         // from tick to tick, the longest that is usual
  double delay = 0.0;            // from reading a position to the force for it, beyond the hold of one period
  double inherentDamping = 0.0;  // b of the device
};

// Returns the largest virtual stiffness, N/mm, for which a sampled wall is passive. It applies to everything that acts
// together with the virtual damping B (N·s/mm): K <= (b - |B|) / (T/2 + t_d) (Colgate and Schenkel 1994, eq. 2-1; with
// a delay Gil et al., JCISE 9(1), 2009). 0 when the damping is not below the device's own.
double stiffnessLimit(const ServoTiming& timing, double virtualDamping);

}  // namespace handwheel
