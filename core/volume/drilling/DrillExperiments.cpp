// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillExperiments.h"

#include "volume/SurfaceToVolume.h"
#include "volume/drilling/DrillRun.h"
#include "volume/drilling/SteppedErosion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

using CheckKind = DrillShapeCheck::Kind;

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// The plate is thicker than the ball's radius by the even stage, mm.
constexpr double kSteadyTravel = 4.0;
// Fewer cycles do not show a steady thrust.
constexpr double kLeastEvenCycles = 10.0;
// mm at either end of it that do not count: voxels at the faces of the plate.
constexpr double kStockMargin = 0.6;

SteppedHole holeOf(DrillExperiment experiment, double value) {
  SteppedHole hole;
  switch (experiment) {
    case DrillExperiment::Resolution:
      hole.voxel = value;
      break;
    case DrillExperiment::Erosion:
      hole.step = value;
      break;
    case DrillExperiment::Radius:
      hole.diameter = 2.0 * value;
      break;
    case DrillExperiment::Feed:
      hole.feed = value;
      break;
  }
  hole.thickness = 0.5 * hole.diameter + kSteadyTravel + 2.0 * kStockMargin;
  return hole;
}

DrillSetup setupOf(const SteppedHole& hole) {
  DrillSetup setup;
  setup.tool.diameter = hole.diameter;
  // (3-21), solved for η. Below 1 material would stay in the head.
  setup.erosion = std::max(1.0, hole.step / 255.0 * hole.voxel * hole.rate / hole.feed);
  return setup;
}

// The plate, its upper face at z = 0, with room around the hole.
Result<SparseVolume> plateOf(const SteppedHole& hole, const Progress& progress) {
  const double half = 0.5 * hole.diameter + std::max(1.5, 2.0 * hole.voxel);
  TriangleSoup box;
  for (int c = 0; c < 8; ++c)
    box.points.emplace_back(c & 1 ? half : -half, c & 2 ? half : -half, c & 4 ? 0.0 : -hole.thickness);
  box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  Result<SurfaceVolume> made = volumeOfSurface(box, hole.voxel, progress);
  if (!made) return made.error();
  return std::move(made->volume);
}

// The thrust of each cycle, from the touch on.
Result<std::vector<float>> drilled(const SteppedHole& hole, const DrillSetup& setup, Progress progress) {
  Result<SparseVolume> plate = plateOf(hole, progress.part(0.0, 0.1));
  if (!plate) return plate.error();
  DrillRun run(*plate, setup);
  const double travel = hole.feed / hole.rate, all = hole.diameter + hole.thickness;
  std::vector<float> thrust;
  // It is placed a cycle before the touch.
  for (double cycle = -1.0; cycle * travel < all; ++cycle) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const DrillTick tick =
        run.move((0.5 * hole.diameter - cycle * travel) * Vec3::UnitZ(), Vec3::UnitZ(), cycle / hole.rate);
    if (cycle >= 0.0) thrust.push_back(static_cast<float>(tick.thrust));
    progress.set(0.1 + 0.9 * std::max(0.0, cycle * travel / all));
  }
  return thrust;
}

EvenLoad evenLoadOf(const SteppedHole& hole, const DrillSetup& setup, const std::vector<float>& thrust) {
  const double travel = hole.feed / hole.rate, radius = 0.5 * hole.diameter;
  // From the centre in the plate on, until the tip comes out.
  const double first = std::ceil((radius + kStockMargin) / travel),
               last = std::floor((hole.thickness - kStockMargin) / travel);
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (double cycle = first; cycle <= last && cycle < static_cast<double>(thrust.size()); ++cycle, ++count) {
    const auto value = static_cast<double>(thrust[static_cast<std::size_t>(cycle)]);
    sum += value;
    squares += value * value;
  }
  EvenLoad even;
  if (!(sum > 0.0)) return even;
  even.mean.thrust = sum / count;
  even.mean.torque = 0.5 * setup.material.tangential * hole.diameter * even.mean.thrust;
  even.ripple = std::sqrt(std::max(0.0, squares / count - even.mean.thrust * even.mean.thrust)) / even.mean.thrust;
  return even;
}

// The correlation of the thrust with time while the ball goes in.
double buildUpOf(const DrillExperimentHole& hole, double cycles) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (; n < cycles && n < static_cast<double>(hole.ourThrust.size()); ++n) {
    const auto value = static_cast<double>(hole.ourThrust[static_cast<std::size_t>(n)]);
    x += n;
    y += value;
    xx += n * n;
    xy += n * value;
    yy += value * value;
  }
  const double spread = (n * xx - x * x) * (n * yy - y * y);
  return spread > 0.0 ? (n * xy - x * y) / std::sqrt(spread) : 0.0;
}

// The least growth from one hole to the next.
template <class Figure>
double leastGrowth(const std::vector<DrillExperimentHole>& holes, Figure figure) {
  double least = kInfinite;
  for (std::size_t i = 1; i < holes.size(); ++i) least = std::min(least, figure(holes[i]) - figure(holes[i - 1]));
  return least;
}

// The power of the value that a figure follows, by the line of least squares through the logarithms.
template <class Figure>
double powerOf(const std::vector<DrillExperimentHole>& holes, Figure figure) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const DrillExperimentHole& hole : holes) {
    if (!(figure(hole) > 0.0)) continue;
    const double u = std::log(hole.value), v = std::log(figure(hole));
    ++n;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  const double spread = n * xx - x * x;
  return spread > 0.0 ? (n * xy - x * y) / spread : 0.0;
}

double ourThrust(const DrillExperimentHole& hole) {
  return hole.ours.mean.thrust;
}

double ourTorque(const DrillExperimentHole& hole) {
  return hole.ours.mean.torque;
}

double ourRipple(const DrillExperimentHole& hole) {
  return hole.ours.ripple;
}

double steppedRipple(const DrillExperimentHole& hole) {
  return hole.stepped.ripple;
}

// The hole of a value; null where there is none.
const DrillExperimentHole* holeAt(const std::vector<DrillExperimentHole>& holes, double value) {
  const auto at = std::find_if(holes.begin(), holes.end(), [&](const auto& hole) { return hole.value == value; });
  return at == holes.end() ? nullptr : &*at;
}

std::vector<DrillExperimentHole> holesWithin(const std::vector<DrillExperimentHole>& holes, double least, double most) {
  std::vector<DrillExperimentHole> within;
  std::copy_if(holes.begin(), holes.end(), std::back_inserter(within),
               [&](const DrillExperimentHole& hole) { return hole.value >= least && hole.value <= most; });
  return within;
}

constexpr double kGrows = 1e-6;  // more than rounding

std::vector<DrillShapeCheck> resolutionChecks(const std::vector<DrillExperimentHole>& holes) {
  const SteppedHole rule;
  std::vector<DrillShapeCheck> checks;
  // In smaller voxels than that of the rule columns are without a voxel that is being removed, from time to time.
  if (const auto coarse = holesWithin(holes, rule.voxel, kInfinite); coarse.size() > 1)
    checks.push_back({CheckKind::SteppedRippleByVoxel, leastGrowth(coarse, steppedRipple), kGrows, kInfinite});
  const DrillExperimentHole* const atRule = holeAt(holes, rule.voxel);
  if (atRule) checks.push_back({CheckKind::SteppedRippleAtRule, steppedRipple(*atRule), 0.0, 0.01});
  if (holes.size() > 1)
    checks.push_back({CheckKind::OurRippleByVoxel, leastGrowth(holes, ourRipple), kGrows, kInfinite});
  // A section that grows as 2 x - x² has √(15/16) = 0.968.
  const double cycles = 0.5 * rule.diameter / rule.feed * rule.rate;
  if (atRule) checks.push_back({CheckKind::BuildUp, buildUpOf(*atRule, cycles), 0.95, 1.0});
  return checks;
}

std::vector<DrillShapeCheck> erosionChecks(const std::vector<DrillExperimentHole>& holes) {
  std::vector<DrillShapeCheck> checks;
  if (holes.size() > 1)
    checks.push_back({CheckKind::SteppedRippleByErosion, leastGrowth(holes, steppedRipple), kGrows, kInfinite});
  if (const DrillExperimentHole* const four = holeAt(holes, 4.0))
    checks.push_back({CheckKind::SteppedRippleAtFour, steppedRipple(*four), 0.1, kInfinite});
  double most = 0.0;
  for (const DrillExperimentHole& hole : holes) most = std::max(most, hole.ours.ripple);
  checks.push_back({CheckKind::OurRippleByErosion, most, 0.0, 0.1});
  return checks;
}

std::vector<DrillShapeCheck> radiusChecks(const std::vector<DrillExperimentHole>& holes) {
  if (holes.size() < 2) return {};
  return {{CheckKind::ThrustByRadius, powerOf(holes, ourThrust), 0.9, 1.1},
          {CheckKind::TorqueByRadius, powerOf(holes, ourTorque), 1.9, 2.1}};
}

std::vector<DrillShapeCheck> feedChecks(const std::vector<DrillExperimentHole>& holes) {
  constexpr double kLinear = 6.0, kFast = 10.0;  // mm/s
  std::vector<DrillShapeCheck> checks;
  const auto slow = holesWithin(holes, 0.0, kLinear);
  if (slow.size() > 1) {
    checks.push_back({CheckKind::ThrustByFeed, powerOf(slow, ourThrust), 0.95, 1.05});
    checks.push_back({CheckKind::TorqueByFeed, powerOf(slow, ourTorque), 0.95, 1.05});
  }
  const DrillExperimentHole* const fast = holeAt(holes, kFast);
  if (!fast || slow.empty()) return checks;
  const DrillExperimentHole& least = slow.front();
  const double share = fast->stepped.mean.thrust * least.value / (least.stepped.mean.thrust * fast->value);
  checks.push_back({CheckKind::SteppedThrustAboveSix, share, 0.0, 0.97});
  return checks;
}

}  // namespace

std::string_view idOf(DrillExperiment experiment) {
  constexpr std::array<std::string_view, kDrillExperiments.size()> kIds{"resolution", "erosion", "radius", "feed"};
  return kIds[static_cast<std::size_t>(experiment)];
}

std::optional<DrillExperiment> drillExperimentOf(std::string_view id) {
  for (const DrillExperiment experiment : kDrillExperiments)
    if (idOf(experiment) == id) return experiment;
  return std::nullopt;
}

std::vector<double> valuesOf(DrillExperiment experiment) {
  switch (experiment) {
    case DrillExperiment::Resolution:
      return {0.255, 0.51, 1.02};
    case DrillExperiment::Erosion:
      return {1.0, 2.0, 4.0, 8.0};
    case DrillExperiment::Radius:
      return {1.0, 2.0, 3.0, 4.0, 5.0};
    case DrillExperiment::Feed:
      return {1.0, 2.0, 4.0, 6.0, 8.0, 10.0};
  }
  return {};
}

bool isDrillable(DrillExperiment experiment, double value) {
  const SteppedHole hole = holeOf(experiment, value);
  return isDrillable(hole) && 2.0 * hole.voxel <= hole.diameter &&
         kLeastEvenCycles * hole.feed <= kSteadyTravel * hole.rate;
}

Result<DrillExperimentHole> drillExperimentHole(DrillExperiment experiment, double value, Progress progress) {
  const SteppedHole hole = holeOf(experiment, value);
  const DrillSetup setup = setupOf(hole);
  Result<std::vector<float>> thrust = drilled(hole, setup, progress);
  if (!thrust) return thrust.error();
  DrillExperimentHole done;
  done.value = value;
  done.ourThrust = std::move(*thrust);
  const double dt = 1.0 / hole.rate;
  for (const double removed : removedBySteps(hole))
    done.itsThrust.push_back(
        static_cast<float>(drillLoad(setup.material, setup.tool, removed, dt, hole.feed, setup.spindle).thrust));
  done.ours = evenLoadOf(hole, setup, done.ourThrust);
  done.stepped = evenLoadOf(hole, setup, done.itsThrust);
  const double section = 0.25 * M_PI * hole.diameter * hole.diameter;
  done.balance = drillLoad(setup.material, setup.tool, section * hole.feed * dt, dt, hole.feed, setup.spindle);
  done.reference = agreeingReference(setup.material, setup.tool, hole.feed, setup.spindle);
  return done;
}

Result<DrillExperimentResult> runDrillExperiment(DrillExperiment experiment, const std::vector<double>& values,
                                                 Progress progress) {
  DrillExperimentResult result{experiment, SteppedHole().rate, {}};
  const auto count = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto at = static_cast<double>(i);
    Result<DrillExperimentHole> hole =
        drillExperimentHole(experiment, values[i], progress.part(at / count, (at + 1.0) / count));
    if (!hole) return hole.error();
    result.holes.push_back(std::move(*hole));
  }
  return result;
}

std::vector<DrillShapeCheck> shapeChecksOf(const DrillExperimentResult& result) {
  if (result.holes.empty()) return {};
  switch (result.experiment) {
    case DrillExperiment::Resolution:
      return resolutionChecks(result.holes);
    case DrillExperiment::Erosion:
      return erosionChecks(result.holes);
    case DrillExperiment::Radius:
      return radiusChecks(result.holes);
    case DrillExperiment::Feed:
      return feedChecks(result.holes);
  }
  return {};
}

}  // namespace handwheel
