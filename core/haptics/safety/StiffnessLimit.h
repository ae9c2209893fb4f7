// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Measured timing of the servo loop, and the damping of the device. Times are in seconds, the damping in N·s/mm.
struct ServoTiming {
  double period = 0.001;  // longest usual time from tick to tick
  double delay = 0.0;     // time from reading a position to the force for it, in addition to the hold of one period
  double inherentDamping = 0.0;  // b of the device
};

// Returns the largest virtual stiffness, N/mm, for which a sampled wall is passive. It applies to the sum of all
// stiffnesses that act together with the virtual damping B (N·s/mm): K <= (b - |B|) / (T/2 + t_d), with the damping b
// of the device, the period T and the delay t_d (Colgate and Schenkel 1994; He 2008, eq. 2-1; with a delay Gil et al.,
// JCISE 9(1), 2009). The result is 0 if the virtual damping is not less than the damping of the device.
double stiffnessLimit(const ServoTiming& timing, double virtualDamping);

}  // namespace handwheel
