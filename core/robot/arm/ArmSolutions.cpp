// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/arm/ArmSolutions.h"

#include "robot/arm/NumericalIk.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSameSolution = 1e-6;       // rad, mm: two solutions count as one if two axes are in line
constexpr double kOtherSolution = 0.05;      // rad, mm: a nearer result of an iteration is no other solution
constexpr std::uint32_t kRandomStarts = 60;  // number of starts
constexpr std::uint64_t kSeed = 1;

bool isKnown(const std::vector<ArmSolution>& found, const ArmValues& values, double apart) {
  return std::any_of(found.begin(), found.end(),
                     [&](const ArmSolution& each) { return (each.values - values).cwiseAbs().maxCoeff() < apart; });
}

// Moves the values of a solution by whole turns into the limits, joint by joint. A joint that no turn brings there is
// as near to the reference as possible, and the first of these is the one beyond its limits.
ArmSolution turnedIntoLimits(const SerialArm& arm, const ArmValues& values, const ArmValues& reference) {
  constexpr double kTurn = 2.0 * M_PI;
  ArmSolution made{values};
  for (Eigen::Index i = 0; i < arm.size(); ++i) {
    const auto within = turnedWithin(arm.joints()[static_cast<std::size_t>(i)], values[i], reference[i]);
    if (!within && !made.beyond) made.beyond = i;
    made.values[i] = within.value_or(values[i] + kTurn * std::round((reference[i] - values[i]) / kTurn));
  }
  constexpr Eigen::Index kCoupled = 2;
  if (!made.beyond && arm.coupling() && !arm.coupling()->isWithin(made.values)) made.beyond = kCoupled;
  return made;
}

std::vector<ArmSolution> closedForm(const ClosedFormIk& closed, const SerialArm& arm, const Pose& tip,
                                    const ArmValues& reference) {
  IkSolutions solutions;
  closed.solve(tip, reference, solutions);
  std::vector<ArmSolution> found;
  for (const IkSolutions::Solution& each : solutions) {
    ArmSolution made = turnedIntoLimits(arm, each.values, reference);
    if (isKnown(found, made.values, kSameSolution)) continue;
    made.configuration = closed.configurationOf(arm, made.values);
    found.push_back(std::move(made));
  }
  return found;
}

// solved: solvedNumerically() or solvedForPosition().
std::vector<ArmSolution> byIteration(const SerialArm& arm, const Pose& tip, const ArmValues& reference,
                                     decltype(solvedNumerically)& solved) {
  NumericalIkSettings settings;
  settings.tolerance = 1e-8;
  settings.seconds = 1.0;  // time limit of a start, which ends long before
  settings.mostStarts = 1;
  RandomSequence sequence(kSeed);
  std::vector<ArmSolution> found;
  ArmValues start = reference;
  for (std::uint32_t i = 0; i <= kRandomStarts && found.size() < kMostNumericalSolutions; ++i) {
    const NumericalIkResult result = solved(arm, tip, start, settings, {});
    fillWithRandom(arm, sequence, start);
    if (!result.isSolved) continue;
    const ArmValues values = withinLimits(arm, result.values, reference).value_or(result.values);
    if (!isKnown(found, values, kOtherSolution)) found.push_back({.values = values, .turnedOff = result.angle});
  }
  return found;
}

std::vector<ArmSolution> byIteration(const SerialArm& arm, const Pose& tip, const ArmValues& reference) {
  std::vector<ArmSolution> found = byIteration(arm, tip, reference, solvedNumerically);
  if (found.empty() && arm.size() < kJointsOfAnyPose) found = byIteration(arm, tip, reference, solvedForPosition);
  return found;
}

}  // namespace

std::vector<ArmSolution> solutionsFor(const SerialArm& arm, const Pose& tip, const ArmValues& reference) {
  const auto closed = ClosedFormIk::of(arm);
  std::vector<ArmSolution> found = closed ? closedForm(*closed, arm, tip, reference) : byIteration(arm, tip, reference);
  std::array<Pose, kMostArmJoints> from, to;
  const auto count = static_cast<std::size_t>(arm.size());
  arm.jointPoses(reference, std::span(from).first(count));
  for (ArmSolution& each : found) {
    arm.jointPoses(each.values, std::span(to).first(count));
    each.distance = jointDistance(std::span(from).first(count), std::span(to).first(count));
  }
  std::stable_sort(found.begin(), found.end(), [&](const ArmSolution& a, const ArmSolution& b) {
    if (a.beyond.has_value() != b.beyond.has_value()) return b.beyond.has_value();
    // The distance does not distinguish solutions with joints that turn in place: their turns do.
    const double distanceOfA = std::round(a.distance / kSameSolution),
                 distanceOfB = std::round(b.distance / kSameSolution);
    if (distanceOfA != distanceOfB) return distanceOfA < distanceOfB;
    return (a.values - reference).squaredNorm() < (b.values - reference).squaredNorm();
  });
  return found;
}

}  // namespace handwheel
