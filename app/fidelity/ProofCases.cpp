// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/ArmAmongBoxes.h"
#include "fidelity/Cases.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kThin = 4.0, kThick = 120.0;  // mm
constexpr double kMicroseconds = 1e3;          // in a ms

struct ClearedMotion {
  ArmValues from, to;
  double clearance;  // mm that it keeps
};

// Motions in an arm's cell.
struct Motions {
  ArmAmongBoxes cell;
  std::vector<ClearedMotion> all = {};
};

// The least distance from what stands around, at points of a motion that are close to each other.
double leastDistance(const RobotScene& scene, const ArmValues& from, const ArmValues& to) {
  constexpr int kPoints = 400;
  double least = 1e6;
  for (int i = 0; i <= kPoints; ++i) {
    const double share = static_cast<double>(i) / kPoints;
    least = std::min(least, scene.nearestObstacle(from + share * (to - from), least).distance);
  }
  return least;
}

// Motions, each with a clearance that it keeps with 2 µm to 5 mm to spare: a proof that is 20 times finer than the
// finest finds all of them free.
Motions closeMotions(double thickness, std::uint64_t seed) {
  constexpr std::size_t kMotions = 60;
  constexpr double kFinest = 5e-5, kLeastSpare = 2e-3, kMostSpare = 5.0;  // mm
  Motions motions{ArmAmongBoxes(thickness, seed)};
  const RobotScene& scene = motions.cell.scene();
  Random random(seed + 1);
  while (motions.all.size() < kMotions) {
    const ArmValues from = motions.cell.anywhereFree(random), to = motions.cell.near(from, random);
    const double spare = kLeastSpare * std::pow(kMostSpare / kLeastSpare, random.between(0.0, 1.0));
    const double clearance = leastDistance(scene, from, to) - spare;
    if (!(clearance >= 0.0) || clearance > 100.0) continue;
    MotionCheckSettings finest;
    finest.clearance = clearance;
    finest.resolution = kFinest;
    if (MotionCheck(scene, from, to, finest).run() == MotionCheck::State::Free)
      motions.all.push_back({from, to, clearance});
  }
  return motions;
}

FidelityCase resolutionCase(const std::string& name, double thickness) {
  const SeededInput<Motions> input([thickness](std::uint64_t seed) { return closeMotions(thickness, seed); });
  return {name, "proof at 0.00005 mm", [input](double value, std::uint64_t seed, Progress) {
            const Motions& motions = input(seed);
            std::size_t refused = 0;
            const double ms = cpuMilliseconds([&] {
              for (const ClearedMotion& each : motions.all) {
                MotionCheckSettings check;
                check.clearance = each.clearance;
                check.resolution = value;
                MotionCheck motion(motions.cell.scene(), each.from, each.to, check);
                refused += motion.run() == MotionCheck::State::Blocked ? 1 : 0;
              }
            });
            const auto count = static_cast<double>(motions.all.size());
            return FidelitySample{100.0 * static_cast<double>(refused) / count, kMicroseconds * ms / count};
          }};
}

// Returns motions between free configurations that collide in between, as the proof has found.
Motions collidingMotions(double thickness, std::uint64_t seed) {
  constexpr std::size_t kMotions = 100;
  Motions motions{ArmAmongBoxes(thickness, seed)};
  const RobotScene& scene = motions.cell.scene();
  Random random(seed + 1);
  while (motions.all.size() < kMotions) {
    const ArmValues from = motions.cell.anywhereFree(random), to = motions.cell.near(from, random);
    if (!scene.isFree(to, 0.1, 0.1)) continue;
    MotionCheck motion(scene, from, to, {});
    if (motion.run() == MotionCheck::State::Blocked && motion.blockedBy().distance <= 0.0)
      motions.all.push_back({from, to, 0.0});
  }
  return motions;
}

// Returns the result of a check at fixed steps.
bool looksFree(const RobotScene& scene, const ClearedMotion& motion, double step) {
  const ArmValues motionVector = motion.to - motion.from;
  const int parts = std::max(1, static_cast<int>(std::ceil(motionVector.cwiseAbs().maxCoeff() / step)));
  for (int i = 0; i <= parts; ++i) {
    if (!scene.isFree(motion.from + (static_cast<double>(i) / parts) * motionVector, 0.0, 0.0)) return false;
  }
  return true;
}

FidelityCase sampledCase(const std::string& name, double thickness) {
  const SeededInput<Motions> input([thickness](std::uint64_t seed) { return collidingMotions(thickness, seed); });
  return {name, "proof by distances", [input](double step, std::uint64_t seed, Progress) {
            const Motions& motions = input(seed);
            std::size_t missed = 0;
            const double ms = cpuMilliseconds([&] {
              for (const ClearedMotion& each : motions.all)
                missed += looksFree(motions.cell.scene(), each, step) ? 1 : 0;
            });
            const auto count = static_cast<double>(motions.all.size());
            return FidelitySample{100.0 * static_cast<double>(missed) / count, kMicroseconds * ms / count};
          }};
}

}  // namespace

std::vector<FidelityCase> planResolutionCases() {
  return {resolutionCase("arm among plates of 4 mm", kThin), resolutionCase("arm among blocks of 120 mm", kThick)};
}

std::vector<FidelityCase> verifyStepCases() {
  return {sampledCase("arm among plates of 4 mm", kThin), sampledCase("arm among blocks of 120 mm", kThick)};
}

}  // namespace handwheel
