// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "haptics/device/PoseTrajectory.h"
#include "haptics/scene/MeshHaptics.h"

#include <string>

namespace handwheel {

// The parameters of a haptic simulation along a path. The tip follows the path exactly, at `rate` ticks a second.
struct HapticPathOptions {
  PoseTrajectory path;
  double from = 0.0, to = 0.0;  // s
  double rate = 1000.0;         // Hz
  // Limits of the device: stiffness (N/mm), damping and force (N). Without a device they are infinite.
  double stiffnessLimit = std::numeric_limits<double>::infinity();
  double dampingLimit = std::numeric_limits<double>::infinity();
  double maxForce = std::numeric_limits<double>::infinity();

  std::size_t ticks() const;
};

// The computed forces along a path, with statistics.
struct HapticPathResult {
  std::string csv;  // a header line, then one line for each tick
  std::size_t ticks = 0;
  std::size_t inContact = 0;
  std::size_t cut = 0;             // number of ticks in which the requested force exceeded the device's largest force
  double askedForce = 0.0;         // N, the largest requested force
  double peakForce = 0.0;          // N, the largest force after the limits
  double usualMicroseconds = 0.0;  // median of the CPU time of a tick
  double slowMicroseconds = 0.0;   // 99th percentile of the CPU time of a tick
};

// Collects the states and forces, tick by tick. Lengths are in mm, forces in N. The columns are:
// t_s,hip_x,hip_y,hip_z,proxy_x,proxy_y,proxy_z,force_x,force_y,force_z,contact,tick_us. Here "hip" is the position of
// the tip (haptic interface point), and tick_us the CPU time of the tick.
class HapticPathTable {
 public:
  HapticPathTable();
  // microseconds: CPU time of the tick. asked: the requested force, before the limit of the device, N.
  void add(const TipState& tip, const ForceOut& felt, double microseconds, double asked);
  HapticPathResult take();

 private:
  HapticPathResult m_result;
  std::vector<double> m_costs;  // us
};

// Computes the haptic forces along a path. The numbers are the same in each run, except for tick_us. If cancelled, the
// result is incomplete.
HapticPathResult feel(const HapticPathOptions& run, MeshHaptics scene, Progress progress);

}  // namespace handwheel
