// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/Cases.h"
#include "fidelity/SeededInput.h"
#include "robot/arm/NumericalIk.h"
#include "robot/dh/DhTable.h"

#include <algorithm>

namespace handwheel {
namespace {

// An arm, and poses that it reaches.
struct ReachedPoses {
  SerialArm arm;
  std::vector<Pose> tips = {};
};

ReachedPoses posesOf(const char* robot, std::uint64_t seed) {
  constexpr std::size_t kPoses = 200;
  const DhTable& table = *libraryTable(robot);
  ReachedPoses poses{armOf(std::vector<DhRow>(table.joints.begin(), table.joints.end()))};
  Random random(seed);
  ArmValues values(poses.arm.size());
  while (poses.tips.size() < kPoses) {
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const ArmJoint& joint = poses.arm.joints()[static_cast<std::size_t>(i)];
      values[i] = random.between(std::max(-M_PI, joint.lower), std::min(M_PI, joint.upper));
    }
    poses.tips.push_back(poses.arm.tipPose(values));
  }
  return poses;
}

FidelityCase caseOf(const char* robot) {
  const SeededInput<ReachedPoses> input([robot](std::uint64_t seed) { return posesOf(robot, seed); });
  return {std::string(robot) + ", from the middle of the joints", "forward kinematics",
          [input](double tolerance, std::uint64_t seed, Progress) {
            const ReachedPoses& poses = input(seed);
            const ArmValues middle = poses.arm.middle();
            NumericalIkSettings settings;
            settings.tolerance = tolerance;
            settings.seconds = 10.0;  // no time decides on the result
            settings.mostStarts = 1000;
            FidelitySample sample;
            sample.cost = cpuMilliseconds([&] {
              for (const Pose& tip : poses.tips) {
                const NumericalIkResult found = solvedNumerically(poses.arm, tip, middle, settings);
                sample.error =
                    std::max(sample.error, found.isSolved ? found.distance : std::numeric_limits<double>::infinity());
              }
            });
            sample.cost *= 1e3 / static_cast<double>(poses.tips.size());
            return sample;
          }};
}

}  // namespace

std::vector<FidelityCase> ikToleranceCases() {
  return {caseOf("irb120"), caseOf("ur5")};
}

}  // namespace handwheel
