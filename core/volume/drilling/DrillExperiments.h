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

// The parameter that reference runs of He (2008, 3.3) vary from hole to hole.
enum class DrillExperiment { Resolution, Erosion, Radius, Feed };
inline constexpr std::array kDrillExperiments{DrillExperiment::Resolution, DrillExperiment::Erosion,
                                              DrillExperiment::Radius, DrillExperiment::Feed};

// Returns the stable id for the command line, such as "resolution".
std::string_view idOf(DrillExperiment experiment);
std::optional<DrillExperiment> drillExperimentOf(std::string_view id);
// Returns the values of the parameter: voxel in mm, erosion in density levels (of 255) that a voxel loses in a cycle,
// radius in mm, or feed in mm/s. The other parameters are constant: a ball of 6 mm, 1 mm/s, 1 kHz, 1000 r/min, voxels
// of 0.255 mm, and a plate of cortical bone.
std::vector<double> valuesOf(DrillExperiment experiment);
// Returns true if a hole with this value can be finished (isDrillable() of SteppedErosion.h) and has a steady load: the
// voxels are at most as large as the ball's radius, and there are at least ten cycles.
bool isDrillable(DrillExperiment experiment, double value);

// The load while the whole front half of the ball is in the plate.
struct EvenLoad {
  DrillLoad mean;
  double ripple = 0.0;  // standard deviation of the thrust, as a fraction of its mean
};

// A hole that was simulated by each method.
struct DrillExperimentHole {
  double value = 0.0;
  EvenLoad ours;        // load by DrillRun
  EvenLoad stepped;     // load by removedBySteps() and drillLoad() (He 2008, A-6 and A-7)
  DrillLoad balance;    // load of a steady cut by the balance of energy, for the cross-section of the ball
  DrillLoad reference;  // load by agreeingReference() (He 2008, 3-22 and 3-23)
  // Thrust in each cycle from the contact on, N. The first is by DrillRun, the second by the stepped erosion.
  std::vector<float> ourThrust, itsThrust;
};

// A statement on the results of an experiment, and the value that was found for it.
struct DrillShapeCheck {
  enum class Kind {
    SteppedRippleByVoxel,    // smaller voxels give less ripple, down to that of drillVoxel()
    SteppedRippleAtRule,     // the voxel of drillVoxel() gives no ripple
    OurRippleByVoxel,        // the ripple of DrillRun decreases, too
    BuildUp,                 // correlation of thrust and time, which is nearly linear while the ball enters
    SteppedRippleByErosion,  // larger steps give more ripple
    SteppedRippleAtFour,     // the ripple is a tenth or more at four steps
    OurRippleByErosion,      // the ripple of DrillRun stays below a tenth for all steps
    ThrustByRadius,          // exponent of the thrust's dependence on the radius
    TorqueByRadius,
    ThrustByFeed,  // exponent of the thrust's dependence on the feed, below 6 mm/s
    TorqueByFeed,
    SteppedThrustAboveSix  // thrust at 10 mm/s, divided by that extrapolated in proportion from the least feed
  };
  Kind kind;
  double found;
  double least, most;  // range in which the statement holds
  bool holds() const { return found >= least && found <= most; }
};

struct DrillExperimentResult {
  DrillExperiment experiment = DrillExperiment::Resolution;
  double rate = 0.0;  // cycles per second, Hz
  std::vector<DrillExperimentHole> holes;
};

// Drills one hole of an experiment with this value, which must be drillable. Errors: the errors of volumeOfSurface();
// Cancelled.
Result<DrillExperimentHole> drillExperimentHole(DrillExperiment experiment, double value, Progress progress);
// Drills a hole for each of these values, which must be drillable.
Result<DrillExperimentResult> runDrillExperiment(DrillExperiment experiment, const std::vector<double>& values,
                                                 Progress progress);

// Returns the checks for which there are enough holes. The holes must be in ascending order of their values.
std::vector<DrillShapeCheck> shapeChecksOf(const DrillExperimentResult& result);

}  // namespace handwheel
