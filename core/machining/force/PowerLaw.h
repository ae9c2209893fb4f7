// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingForceModel.h"

namespace handwheel {

// A law F = C d^x f^y v^n, ready for the servo loop. d is the depth, f the feed and v the speed of CutConditions.
struct PowerLaw {
  double logC = 0.0;  // ln of C in N
  double x = 0.0, y = 0.0, n = 0.0;

  // Returns the force, N. The conditions must be a result of bounded(), with a depth above zero, because a negative
  // exponent has a pole at 0.
  double at(const CutConditions& cut) const noexcept;
};

}  // namespace handwheel
