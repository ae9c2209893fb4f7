// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "fidelity/CaseShapes.h"
#include "fidelity/SeededInput.h"
#include "haptics/snap/SnapFidelity.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

namespace handwheel {
namespace {

// Target points, and a hand that moves to some of them, tick by tick.
struct Hands {
  SnapField field;
  double spacing = 0.0;     // mm, mean distance between neighbours
  std::vector<Vec3> hands;  // kSnapTicks for each target
  std::vector<std::uint32_t> targets;
};

constexpr std::size_t kSnapTicks = 300;  // for each target, the last third of them at it
constexpr std::size_t kTargets = 200;
constexpr double kFar = 10.0;  // spacings from where the hand sets out,
constexpr double kAim = 0.2,
                 kTremor = 0.03;  // distance by which it misses the target, and amplitude of its trembling there

Vec3 scatter(Random& random, double size) {
  // Nearly normal, and the same on every machine.
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < 3; ++i) sum += random.direction() * random.between(0.0, 1.0);
  return sum * size;
}

// Minimum-jerk, as hands move (Flash and Hogan, J. Neuroscience 5(7), 1985).
double progressOf(double t) {
  return t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
}

void addPaths(Hands& scene, const std::vector<Vec3>& points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = 0; i < kTargets; ++i) {
    const auto target = static_cast<std::uint32_t>(random.below(points.size()));
    const Vec3 from = points[target] + kFar * scene.spacing * random.direction();
    const Vec3 to = points[target] + scatter(random, kAim * scene.spacing);
    scene.targets.push_back(target);
    for (std::size_t tick = 0; tick < kSnapTicks; ++tick) {
      const double t = std::min(1.0, 1.5 * static_cast<double>(tick) / static_cast<double>(kSnapTicks));
      scene.hands.push_back(from + (to - from) * progressOf(t) + scatter(random, kTremor * scene.spacing));
    }
  }
}

Hands handsOver(const std::vector<Vec3>& points, double spacing, std::uint64_t seed) {
  Hands scene;
  scene.spacing = spacing;
  SnapFeatures features;
  for (std::uint32_t i = 0; i < points.size(); ++i) features.addPoint(i, points[i]);
  scene.field = SnapField(features);
  addPaths(scene, points, seed);
  return scene;
}

std::vector<Vec3> pointsInBall(std::size_t count, double radius, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(random.direction() * radius * std::cbrt(random.between(0.0, 1.0)));
  return points;
}

// The share of targets that are not what the hand holds in the end.
FidelitySample missed(const Hands& scene, double radius) {
  const SnapProfile profile(SnapShape::Quadratic, 0.5, radius * scene.spacing);
  std::size_t misses = 0;
  FidelitySample sample;
  sample.cost = cpuMilliseconds([&] {
    for (std::size_t i = 0; i < scene.targets.size(); ++i) {
      SnapProxy proxy;
      for (std::size_t tick = 0; tick < kSnapTicks; ++tick)
        proxy.step(scene.field, profile, scene.hands[i * kSnapTicks + tick]);
      misses += !proxy.isHeld() || proxy.held().id != scene.targets[i];
    }
  });
  sample.cost *= 1e3 / static_cast<double>(scene.hands.size());
  sample.error = 100.0 * static_cast<double>(misses) / static_cast<double>(scene.targets.size());
  return sample;
}

FidelityCase radiusCase(const std::string& name, std::function<Hands(std::uint64_t)> make) {
  const SeededInput<Hands> input(std::move(make));
  return {name, "the feature that the scripted hand goes to",
          [input](double value, std::uint64_t seed, Progress) { return missed(input(seed), value); }};
}

// Features, and positions of the hand among them (mm).
struct Crowd {
  SnapField field;
  std::vector<Vec3> hands;
};

constexpr std::size_t kHands = 500;

Crowd meshCrowd(std::uint64_t seed) {
  const TriangleSoup soup = sphereSoup(4, 20.0);  // edges of about 1.3 mm
  SnapFeatures features;
  for (std::uint32_t i = 0; i < soup.points.size(); ++i) features.addPoint(i, soup.points[i]);
  for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
    const Triangle& t = soup.triangles[i];
    features.addTriangle(i, soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]);
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] < t[(k + 1) % 3])
        features.addSegment(3 * i + static_cast<std::uint32_t>(k), soup.points[t[k]], soup.points[t[(k + 1) % 3]]);
  }
  Crowd crowd{SnapField(features), {}};
  Random random(seed);
  for (std::size_t i = 0; i < kHands; ++i) crowd.hands.push_back(random.direction() * random.between(18.5, 21.5));
  return crowd;
}

Crowd pointCrowd(std::uint64_t seed) {
  SnapFeatures features;
  const std::vector<Vec3> points = pointsInBall(10'000, 20.0, seed);
  for (std::uint32_t i = 0; i < points.size(); ++i) features.addPoint(i, points[i]);
  Crowd crowd{SnapField(features), {}};
  Random random(seed + 1);
  for (std::size_t i = 0; i < kHands; ++i) crowd.hands.push_back(random.direction() * random.between(0.0, 18.0));
  return crowd;
}

FidelitySample against(const Crowd& crowd, double distance, std::size_t most) {
  const SnapProfile profile(SnapShape::Quadratic, 0.5, distance);
  std::vector<Vec3> forces(crowd.hands.size());
  SnapSum sum(most), all(SnapSum::kLargest);
  FidelitySample sample;
  sample.cost = cpuMilliseconds([&] {
    for (std::size_t i = 0; i < forces.size(); ++i) forces[i] = sum.step(crowd.field, profile, crowd.hands[i]).force;
  });
  sample.cost *= 1e3 / static_cast<double>(forces.size());
  double difference = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const SnapResult ideal = all.step(crowd.field, profile, crowd.hands[i]);
    difference += (forces[i] - ideal.force).squaredNorm();
    whole += ideal.force.squaredNorm();
  }
  sample.error = 100.0 * std::sqrt(difference / whole);
  return sample;
}

FidelityCase crowdCase(const std::string& name, double distance, Crowd (*make)(std::uint64_t)) {
  const SeededInput<Crowd> input(make);
  return {name, "the sum over all in reach", [input, distance](double value, std::uint64_t seed, Progress) {
            return against(input(seed), distance, static_cast<std::size_t>(value));
          }};
}

}  // namespace

std::vector<FidelityCase> snapRadiusCases() {
  return {radiusCase("vertices of a sphere",
                     [](std::uint64_t seed) {
                       const std::vector<Vec3> points = sphereSoup(5, 40.0).points;
                       const double spacing = 40.0 * std::sqrt(4.0 * M_PI / static_cast<double>(points.size()));
                       return handsOver(points, spacing, seed);
                     }),
          radiusCase("points scattered in a ball", [](std::uint64_t seed) {
            const std::vector<Vec3> points = pointsInBall(10'000, 20.0, seed);
            return handsOver(points, 20.0 * std::cbrt(4.0 / 3.0 * M_PI / static_cast<double>(points.size())), seed);
          })};
}

std::vector<FidelityCase> snapFeaturesCases() {
  return {crowdCase("mesh, within half an edge", 0.65, meshCrowd), crowdCase("mesh, within an edge", 1.3, meshCrowd),
          crowdCase("points, 20 in reach", 2.5, pointCrowd), crowdCase("points, 800 in reach", 8.5, pointCrowd)};
}

}  // namespace handwheel
