// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadChip.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

TurnChip chipOf(const ThreadGroove& groove, const PartThreads* before, double middle, double surface) {
  constexpr int kParts = 256;
  constexpr double kThinnest = 1e-6;  // mm
  const double out = groove.side() == TurningSide::Bore ? -1.0 : 1.0;
  const double step = groove.cut().pitch / kParts, begin = middle - 0.5 * groove.cut().pitch;
  TurnChip chip;
  for (int i = 0; i < kParts; ++i) {
    const double z = begin + step * (i + 0.5);
    double left = out * surface;  // height of the remaining material
    if (before) {
      for (const ThreadGroove& each : before->grooves())
        if (each.side() == groove.side()) left = std::min(left, out * each.radius(z, 0.0));
    }
    const double depth = left - out * groove.radius(z, 0.0);
    if (!(depth > kThinnest)) continue;
    chip.area += depth * step;
    const double rise = groove.radius(z + 0.5 * step, 0.0) - groove.radius(z - 0.5 * step, 0.0);
    chip.width += std::isfinite(rise) ? std::hypot(step, rise) : step;  // not at the end of the groove
  }
  return chip;
}

}  // namespace handwheel
