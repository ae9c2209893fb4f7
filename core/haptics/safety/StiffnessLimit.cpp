// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety/StiffnessLimit.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

double stiffnessLimit(const ServoTiming& timing, double virtualDamping) {
  const double spare = timing.inherentDamping - std::abs(virtualDamping);
  const double lag = 0.5 * timing.period + timing.delay;
  if (!(spare > 0.0) || !(lag > 0.0)) return 0.0;  // NaN, too
  return spare / lag;
}

}  // namespace handwheel
