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

// The parameter that a reference run of He (2008, 3.3) varies from hole to hole.
enum class DrillExperiment { Resolution, Erosion, Radius, Feed };
inline constexpr std::array kDrillExperiments{DrillExperiment::Resolution, DrillExperiment::Erosion,
                                              DrillExperiment::Radius, DrillExperiment::Feed};

// Stable, for the command line: "resolution".
std::string_view idOf(DrillExperiment experiment);
std::optional<DrillExperiment> drillExperimentOf(std::string_view id);
// Returns the values of the parameter: voxel in mm, erosion in steps of 255 levels, radius in mm, feed in mm/s. The
// other parameters are those of a ball of 6 mm at 1 mm/s, 1 kHz and 1000 r/min, in voxels of 0.255 mm and a plate of
// cortical bone.
std::vector<double> valuesOf(DrillExperiment experiment);
// Returns true if a hole with this value can be finished (isDrillable()) and has a steady load: voxels of at most the
// ball's radius, and at least ten cycles.
bool isDrillable(DrillExperiment experiment, double value);

// The load while the whole front half of the ball is in the plate.
struct EvenLoad {
  DrillLoad mean;
  double ripple = 0.0;  // standard deviation of the thrust, as a share of its mean
};

// One hole, simulated by each method.
struct DrillExperimentHole {
  double value = 0.0;
  EvenLoad ours;        // DrillRun
  EvenLoad stepped;     // removedBySteps(), with the loads of
  DrillLoad balance;    // load of a steady cut by the balance of energy, with the cross-section of the ball
  DrillLoad reference;  // load by (3-22) and (3-23), with constants that agree with the balance
  // Thrust in each cycle from the contact on, N: by DrillRun, and by the stepped erosion.
  std::vector<float> ourThrust, itsThrust;
};

// A stated property of the curves, and the value that was found.
struct DrillShapeCheck {
  enum class Kind {
    SteppedRippleByVoxel,    // smaller voxels give less ripple, down to the rule of resolution
    SteppedRippleAtRule,     // no ripple with the voxel of the rule
    OurRippleByVoxel,        // our ripple decreases, too
    BuildUp,                 // thrust grows nearly linearly while the ball enters: correlation
    SteppedRippleByErosion,  // larger steps give more ripple
    SteppedRippleAtFour,     // ripple of a tenth or more at four steps
    OurRippleByErosion,      // our ripple stays below a tenth for all steps
    ThrustByRadius,          // exponent of the radius
    TorqueByRadius,
    ThrustByFeed,  // exponent of the feed, below 6 mm/s
    TorqueByFeed,
    SteppedThrustAboveSix  // ratio of the thrust at 10 mm/s to the line through that at the least feed
  };
  Kind kind;
  double found;
  double least, most;  // range in which the statement holds
  bool holds() const { return found >= least && found <= most; }
};

struct DrillExperimentResult {
  DrillExperiment experiment = DrillExperiment::Resolution;
  double rate = 0.0;  // Hz
  std::vector<DrillExperimentHole> holes;
};

// Drills one hole of an experiment with this value, which must be drillable. Errors: those of volumeOfSurface();
// Cancelled.
Result<DrillExperimentHole> drillExperimentHole(DrillExperiment experiment, double value, Progress progress);
// Drills a hole for each of these values, which must be drillable.
Result<DrillExperimentResult> runDrillExperiment(DrillExperiment experiment, const std::vector<double>& values,
                                                 Progress progress);

// Returns the checks that the holes suffice for. The holes must be in ascending order of their values.
std::vector<DrillShapeCheck> shapeChecksOf(const DrillExperimentResult& result);

}  // namespace handwheel
