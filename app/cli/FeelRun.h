// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "haptics/HandPath.h"
#include "haptics/SceneForces.h"

#include <string>

namespace handwheel {

// How a path is felt: the tip goes exactly where it says, at this many ticks a second.
struct FeelRun {
  HandPath path;
  double from = 0.0, to = 0.0;  // s
  double rate = 1000.0;         // Hz
  // Of a device that must carry it: what it may be stiff by (N/mm), and give (N). Infinite without one.
  double stiffnessLimit = std::numeric_limits<double>::infinity();
  double dampingLimit = std::numeric_limits<double>::infinity();
  double maxForce = std::numeric_limits<double>::infinity();

  std::size_t ticks() const;
};

struct FeltPath {
  std::string csv;  // a line of names, then one for each tick
  std::size_t ticks = 0;
  std::size_t inContact = 0;
  std::size_t cut = 0;             // in which more was asked than the device gives,
  double askedForce = 0.0;         // N: the most that was asked,
  double peakForce = 0.0;          // and that was given
  double usualMicroseconds = 0.0;  // median of the CPU time of a tick,
  double slowMicroseconds = 0.0;   // and what 99 of 100 stay below
};

// t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us: mm, N. The same numbers in
// each run but for tick_us. Incomplete once cancelled.
FeltPath feel(const FeelRun& run, SceneFeel scene, Progress progress);

}  // namespace handwheel
