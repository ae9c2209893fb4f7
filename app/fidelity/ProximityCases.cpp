// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "collision/ProximityQuery.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/SeededInput.h"

#include <algorithm>

namespace handwheel {
namespace {

// A body that is led past another one.
struct Passage {
  std::vector<CollisionBody> bodies;
  std::vector<Pose> poses = {};        // poses of the first; the second does not move
  std::vector<double> distances = {};  // mm, exactly
};

std::vector<NearPair> nearAt(ProximityQuery& query, const Pose& pose) {
  constexpr double kFar = 1e6;
  std::vector<NearPair> near;
  query.place(0, pose);
  query.findNear(kFar, near);
  return near;
}

// Around it, some mm away, turning.
Passage passageOf(const TriangleSoup& moved, const TriangleSoup& standing, double away, std::uint64_t seed) {
  constexpr int kPoses = 300;
  constexpr double kWave = 5.0, kStep = 0.01;  // mm, rad
  const auto bodyOf = [](const TriangleSoup& soup) {
    return CollisionBody({CollisionPiece::ofMesh(Pose::Identity(), std::make_shared<const CollisionMesh>(soup))});
  };
  Passage passage{{bodyOf(moved), bodyOf(standing)}};
  Random random(seed);
  const Vec3 axis = random.direction();
  const double begin = random.between(0.0, 2.0 * M_PI);
  ProximityQuery exact(passage.bodies, {{0, 1}});
  for (int i = 0; i < kPoses; ++i) {
    const double angle = begin + kStep * i, distance = away + kWave * std::sin(7.0 * angle);
    Pose pose(Eigen::Translation3d(distance * std::cos(angle), distance * std::sin(angle), 20.0 * std::sin(3 * angle)));
    pose.rotate(Eigen::AngleAxisd(angle, axis));
    passage.poses.push_back(pose);
    passage.distances.push_back(nearAt(exact, pose).front().points.distance);
  }
  return passage;
}

FidelityCase caseOf(const std::string& name, std::function<Passage(std::uint64_t)> make) {
  const SeededInput<Passage> input(std::move(make));
  return {name, "exact distance", [input](double tolerance, std::uint64_t seed, Progress) {
            const Passage& passage = input(seed);
            ProximityQuery query(passage.bodies, {{0, 1}});
            query.setTolerance(tolerance);
            FidelitySample sample;
            const double ms = cpuMilliseconds([&] {
              for (std::size_t i = 0; i < passage.poses.size(); ++i) {
                const double found = nearAt(query, passage.poses[i]).front().points.distance;
                sample.error = std::max(sample.error, found - passage.distances[i]);
              }
            });
            sample.cost = 1e3 * ms / static_cast<double>(passage.poses.size());
            return sample;
          }};
}

}  // namespace

std::vector<FidelityCase> proximityToleranceCases() {
  return {caseOf("ball around a torus",
                 [](std::uint64_t seed) {
                   return passageOf(sphereSoup(4, 30.0), torusSoup(120, 60, 100.0, 30.0), 175.0, seed);
                 }),
          caseOf("torus around a torus", [](std::uint64_t seed) {
            return passageOf(torusSoup(60, 30, 40.0, 12.0), torusSoup(120, 60, 100.0, 30.0), 195.0, seed);
          })};
}

}  // namespace handwheel
