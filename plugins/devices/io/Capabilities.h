// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace handwheel {

// Estimates the inherent damping of a device, N·s/mm, from its stated stiffness. Manufacturers do not publish it. But a
// wall of the stiffness (N/mm) that they state, at their rate (Hz), can only be passive with at least this much (eq.
// 2-1): b = K·T/2.
constexpr double inherentDampingFor(double stiffness, double rate) {
  return 0.5 * stiffness / rate;
}

}  // namespace handwheel
