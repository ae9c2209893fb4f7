// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "haptics/device/PoseTrajectory.h"
#include "volume/HybridPart.h"
#include "volume/drilling/DrillRecord.h"

namespace handwheel {

// Returns the operation that drills a volume along a path.
const Operation& drillOperation();

// Returns the drill that the parameters describe. Errors: VolumeErrors::NoSuchDrill, NoSuchDrillMaterial.
Result<DrillSetup> drillSetupOf(const OperationValues& values);

struct Drilled {
  SparseVolume volume;                      // remaining volume; empty for a HybridPart
  std::shared_ptr<const DrillRecord> hole;  // record for replaying the hole
  std::vector<DrillTick> ticks;             // ticks with thrust or removal
  double removed = 0.0;                     // mm³
  double maxThrust = 0.0;                   // N
  double maxTorque = 0.0;                   // N·mm
  double energy = 0.0;                      // J
  std::optional<double> breakthrough;       // s
  double seconds = 0.0;                     // duration of the path
};

// Drills along a path of the head's centre in cycles of `rate` Hz. The shank is the +z axis of the poses. Errors:
// VolumeErrors::PathTooLong (more poses than DrillRecord::kMostPoses), Cancelled.
Result<Drilled> drillAlong(SparseVolume volume, const DrillSetup& setup, const PoseTrajectory& path, double rate,
                           Progress progress);
// Drills a part whose voxels are made along the path. Ends early if the voxels turn out not to be exact. Additional
// error: VolumeErrors::TooLarge, if the cut takes more memory than the system has.
Result<Drilled> drillAlong(HybridPart& part, const DrillSetup& setup, const PoseTrajectory& path, double rate,
                           Progress progress);

}  // namespace handwheel
