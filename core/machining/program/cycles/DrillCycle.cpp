// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/DrillCycle.h"

namespace handwheel {

void DrillCycle::run(ProgramMachine& machine, const SourceLocation& location) const {
  constexpr double kMostSteps = 1e5;
  if (peck > 0.0 && !((retract - depth) / peck <= kMostSteps))
    refuse(location, "Q", "the cycle has more than 100000 steps", "Use a larger step.");
  const auto rapid = [&](double z) { machine.rapid({radius, z}, location); };
  if (machine.at().y() < retract) machine.rapid({machine.at().x(), retract}, location);
  rapid(machine.at().y());
  rapid(retract);
  for (double z = retract - peck; peck > 0.0 && z > depth; z -= peck) {
    machine.feed({radius, z}, location);
    if (isDeep) rapid(retract);
    rapid(z + kClearance);
  }
  machine.feed({radius, depth}, location);
  if (dwell > 0.0) machine.dwell(dwell, location);
  if (feedsOut) machine.feed({radius, retract}, location);
  rapid(end);
}

}  // namespace handwheel
