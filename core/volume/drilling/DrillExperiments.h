// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "volume/drilling/DrillForce.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace handwheel {

// What a reference run of He (2008, 3.3) changes from hole to hole.
enum class DrillExperiment { Resolution, Erosion, Radius, Feed };
inline constexpr std::array kDrillExperiments{DrillExperiment::Resolution, DrillExperiment::Erosion,
                                              DrillExperiment::Radius, DrillExperiment::Feed};

// Stable, for the command line: "resolution".
std::string_view idOf(DrillExperiment experiment);
std::optional<DrillExperiment> drillExperimentOf(std::string_view id);
// The values that it runs through: mm of a voxel, steps of 255 levels, mm of the radius, mm/s. All else is that of a
// ball of 6 mm at 1 mm/s and 1 kHz, in voxels of 0.255 mm and a plate of cortical bone, at 1000 r/min.
std::vector<double> valuesOf(DrillExperiment experiment);
// Whether a hole with this value comes to an end (isDrillable()) and has an even load: voxels of no more than the
// ball's radius, and at least ten cycles.
bool isDrillable(DrillExperiment experiment, double value);

// Where all of the front half of the ball is in the plate.
struct EvenLoad {
  DrillLoad mean;
  double ripple = 0.0;  // standard deviation of the thrust, as a share of its mean
};

// One hole, by each way.
struct DrillExperimentHole {
  double value = 0.0;
  EvenLoad ours;        // DrillRun
  EvenLoad stepped;     // removedBySteps(), with the loads of
  DrillLoad balance;    // of the energy, with the section of the ball: what an even cut takes
  DrillLoad reference;  // (3-22) and (3-23), with constants that agree with the balance
  // N, of each cycle from the touch on: of DrillRun, and of the steps.
  std::vector<float> ourThrust, itsThrust;
};

// What is stated of the curves, and what was found.
struct DrillShapeCheck {
  enum class Kind {
    SteppedRippleByVoxel,    // smaller voxels, less ripple, down to the rule of resolution
    SteppedRippleAtRule,     // with the voxel of the rule there is none
    OurRippleByVoxel,        // ours falls, too
    BuildUp,                 // thrust grows nearly linearly while the ball goes in: correlation
    SteppedRippleByErosion,  // larger steps, more ripple
    SteppedRippleAtFour,     // a tenth and more at four steps
    OurRippleByErosion,      // ours stays below a tenth at all
    ThrustByRadius,          // power of the radius
    TorqueByRadius,
    ThrustByFeed,  // power of the feed, below 6 mm/s
    TorqueByFeed,
    SteppedThrustAboveSix  // what the thrust at 10 mm/s is of what the line through that at the least feed has there
  };
  Kind kind;
  double found;
  double least, most;  // between which it is as stated
  bool holds() const { return found >= least && found <= most; }
};

struct DrillExperimentResult {
  DrillExperiment experiment = DrillExperiment::Resolution;
  double rate = 0.0;  // Hz
  std::vector<DrillExperimentHole> holes;
};

// One hole of an experiment with this value, which is drillable. Errors: those of volumeOfSurface(); Cancelled.
Result<DrillExperimentHole> drillExperimentHole(DrillExperiment experiment, double value, Progress progress);
// A hole for each of these values, which are drillable.
Result<DrillExperimentResult> runDrillExperiment(DrillExperiment experiment, const std::vector<double>& values,
                                                 Progress progress);

// The stated shapes, of holes in ascending order of their values; those for which the holes are there.
std::vector<DrillShapeCheck> shapeChecksOf(const DrillExperimentResult& result);

}  // namespace handwheel
