// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Bars.h"
#include "haptics/snap/SnapProxy.h"
#include "haptics/snap/SnapSum.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Simple_cartesian.h>

#include <map>
#include <random>

using namespace handwheel;

namespace {

bench::Bars bars;

constexpr double kRadius = 50.0;  // mm, of the sphere on which the features lie
constexpr std::size_t kTicks = 20'000;

enum class Kinds { Points, All };

Vec3 onSphere(std::mt19937& random) {
  std::normal_distribution<double> number;
  const double x = number(random), y = number(random);
  return kRadius * Vec3(x, y, number(random)).normalized();
}

// Returns the spacing for an equal piece of the sphere for each feature.
double spacingOf(std::size_t count) {
  return kRadius * std::sqrt(4.0 * M_PI / static_cast<double>(count));
}

struct Scene {
  std::vector<SnapItem> items;
  SnapField field;
  double buildSeconds = 0.0;
};

// Points, or points, segments and triangles by turns.
const Scene& sceneOf(std::size_t count, Kinds kinds) {
  static std::map<std::pair<std::size_t, Kinds>, Scene> scenes;
  auto [at, isNew] = scenes.try_emplace({count, kinds});
  if (!isNew) return at->second;
  std::mt19937 random(1);
  SnapFeatures features;
  const double size = spacingOf(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3 a = onSphere(random);
    const Vec3 b = a + size * onSphere(random) / kRadius, c = a + size * onSphere(random) / kRadius;
    if (kinds == Kinds::Points || i % 3 == 0)
      features.addPoint(i, a);
    else if (i % 3 == 1)
      features.addSegment(i, a, b);
    else
      features.addTriangle(i, a, b, c);
  }
  at->second.items.assign(features.items().begin(), features.items().end());
  at->second.buildSeconds = bench::secondsOf([&] { at->second.field = SnapField(features); });
  return at->second;
}

// A hand over the sphere, in and out by a snap distance, with a tremor: at 100 mm/s and 0.05 mm where there are 10,000
// features, and past as many of them in a tick where there are more or fewer.
std::vector<Vec3> slide(std::size_t count, double distance) {
  std::mt19937 random(2);
  const double share = spacingOf(count) / spacingOf(10'000);
  std::normal_distribution<double> tremor(0.0, 0.05 * share);
  std::vector<Vec3> hands;
  for (std::size_t i = 0; i < kTicks; ++i) {
    const double t = 1e-3 * static_cast<double>(i), angle = 100.0 * share / kRadius * t;
    const Vec3 foot(std::cos(angle), std::sin(angle) * std::cos(0.3 * t), std::sin(angle) * std::sin(0.3 * t));
    const double x = tremor(random), y = tremor(random);
    hands.push_back(foot * (kRadius + distance * std::sin(7.0 * t)) + Vec3(x, y, tremor(random)));
  }
  return hands;
}

struct Microseconds {
  double middle = 0.0, p99 = 0.0;
};

template <class Step>
Microseconds timesOf(const std::vector<Vec3>& hands, Step step) {
  std::vector<double> times;
  times.reserve(hands.size());
  for (const Vec3& hand : hands) times.push_back(1e6 * bench::secondsOf([&] { benchmark::DoNotOptimize(step(hand)); }));
  std::sort(times.begin(), times.end());
  return {times[times.size() / 2], times[times.size() * 99 / 100]};
}

// Features within the snap distance of the hand, on average.
double inReach(const Scene& scene, const std::vector<Vec3>& hands, double distance) {
  double count = 0.0;
  const double limit = distance * distance;
  for (const Vec3& hand : hands)
    for (std::size_t d = 0; d < SnapField::kDimensions; ++d)
      scene.field.layer(d).forEachNear(
          hand - scene.field.origin(), [&] { return limit; }, [&](const auto&...) { ++count; });
  return count / static_cast<double>(hands.size());
}

// The force of each feature, one after the other: what an index has to beat.
Vec3 sumOfAll(const Scene& scene, const SnapProfile& profile, const Vec3& hand) {
  Vec3 force = Vec3::Zero();
  for (const SnapItem& item : scene.items) {
    const Vec3 offset = item.closestTo(hand) - hand;
    const double x = offset.norm();
    if (const double f = profile.force(x); f > 0.0) force += (f / x) * offset;
  }
  return force;
}

void report(benchmark::State& state, const Microseconds& times) {
  state.counters["us"] = times.middle;
  state.counters["us99"] = times.p99;
}

std::string thousands(std::size_t count) {
  return std::to_string(count / 1000) + ",000 features";
}

// Both methods at one number of features, the snap distance twice what they are apart. The linear loop in the same run.
void features(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const Scene& scene = sceneOf(count, Kinds::All);
  const SnapProfile profile(SnapShape::Gaussian, 0.5, 2.0 * spacingOf(count));
  const std::vector<Vec3> hands = slide(count, profile.distance());
  Microseconds sums, proxies, loops;
  for (auto _ : state) {
    SnapSum sum;
    SnapProxy proxy;
    sums = timesOf(hands, [&](const Vec3& hand) { return sum.step(scene.field, profile, hand).force; });
    proxies = timesOf(hands, [&](const Vec3& hand) { return proxy.step(scene.field, profile, hand).force; });
    const std::vector<Vec3> some(hands.begin(), hands.begin() + 20);
    loops = timesOf(some, [&](const Vec3& hand) { return sumOfAll(scene, profile, hand); });
  }
  report(state, proxies);
  state.counters["sum_us"] = sums.middle;
  state.counters["sum_us99"] = sums.p99;
  state.counters["loop_us"] = loops.middle;
  const double near = inReach(scene, hands, profile.distance());
  if (near < 1.0) return bars.failed(state, thousands(count), "none is in reach");
  state.counters["in_reach"] = near;
  state.counters["build_ms"] = 1e3 * scene.buildSeconds;
  static std::map<std::size_t, std::pair<double, double>> middles;
  middles[count] = {sums.middle, proxies.middle};
  if (count == 10'000) {
    bars.atMost("force method, " + thousands(count) + ", median us", 5.0, sums.middle);
    bars.atMost("force method, " + thousands(count) + ", p99 us", 5.0, sums.p99);
    bars.atMost("proxy method, " + thousands(count) + ", median us", 5.0, proxies.middle);
    bars.atMost("proxy method, " + thousands(count) + ", p99 us", 5.0, proxies.p99);
    bars.atMost("force method to a loop over " + thousands(count), 0.1, sums.middle / loops.middle);
  }
  if (count == 1'000'000) {
    const std::string toAThousand = "force method, a million features to a thousand";
    if (!middles.contains(1'000)) return bars.skipped(state, toAThousand, "features/1000 did not run");
    // log 1,000,000 / log 1,000
    bars.atMost(toAThousand, 2.0, sums.middle / middles[1'000].first);
    bars.atMost("proxy method, a million features to a thousand", 2.0, proxies.middle / middles[1'000].second);
  }
}

// All of 10,000 features within the snap distance: more than may act.
void crowd(benchmark::State& state) {
  const Scene& scene = sceneOf(10'000, Kinds::All);
  const SnapProfile profile(SnapShape::Gaussian, 0.5, 3.0 * kRadius);
  const std::vector<Vec3> hands = slide(10'000, 2.0);
  const std::string crowded = "force method, 10,000 features all in reach, p99 us";
  const std::vector<Vec3> some(hands.begin(), hands.begin() + 10);
  if (inReach(scene, some, profile.distance()) != 10'000.0) return bars.failed(state, crowded, "not all are in reach");
  Microseconds sums, proxies;
  for (auto _ : state) {
    SnapSum sum(static_cast<std::size_t>(state.range(0)));
    SnapProxy proxy;
    sums = timesOf(hands, [&](const Vec3& hand) { return sum.step(scene.field, profile, hand).force; });
    proxies = timesOf(hands, [&](const Vec3& hand) { return proxy.step(scene.field, profile, hand).force; });
  }
  report(state, proxies);
  state.counters["sum_us"] = sums.middle;
  state.counters["sum_us99"] = sums.p99;
  if (state.range(0) != SnapSum::kMost) return;
  bars.atMost(crowded, 50.0, sums.p99);
  bars.atMost("proxy method, 10,000 features all in reach, p99 us", 5.0, proxies.p99);
}

// A ring of 10,000 points as one curve: what its samples in reach cost. To choose a sampling by.
void curve(benchmark::State& state) {
  const auto reach = static_cast<double>(state.range(0));  // samples to each side of the hand
  const double length = 2.0 * M_PI * kRadius / 10'000;
  std::vector<Vec3> ring;
  for (int i = 0; i < 10'000; ++i)
    ring.push_back(kRadius * Vec3(std::cos(2e-4 * M_PI * i), std::sin(2e-4 * M_PI * i), 0.0));
  SnapFeatures features;
  features.addCurve(0, ring, true);
  const SnapField field(features);
  const SnapProfile profile(SnapShape::Gaussian, 0.5, reach * length);
  std::vector<Vec3> hands;
  for (std::size_t i = 0; i < kTicks; ++i) {
    const double angle = 0.1 / kRadius * static_cast<double>(i);
    hands.push_back((kRadius + 0.3 * profile.distance()) * Vec3(std::cos(angle), std::sin(angle), 0.0));
  }
  Microseconds sums, proxies;
  for (auto _ : state) {
    SnapSum sum;
    SnapProxy proxy;
    sums = timesOf(hands, [&](const Vec3& hand) { return sum.step(field, profile, hand).force; });
    proxies = timesOf(hands, [&](const Vec3& hand) { return proxy.step(field, profile, hand).force; });
  }
  report(state, proxies);
  state.counters["sum_us"] = sums.middle;
  state.counters["sum_us99"] = sums.p99;
  if (state.range(0) != 10) return;
  bars.atMost("force method, curve of 10,000 points, 20 in reach, p99 us", 5.0, sums.p99);
  bars.atMost("proxy method, curve of 10,000 points, 20 in reach, p99 us", 5.0, proxies.p99);
}

// Finds the nearest of many points, in turns with CGAL's kd tree, at random positions, while those of a servo loop are
// next to each other. For comparison, without a bar: the kd tree knows points only, and neither reach nor ties.
void nearestPoint(benchmark::State& state) {
  using Kernel = CGAL::Simple_cartesian<double>;
  using Search = CGAL::Orthogonal_k_neighbor_search<CGAL::Search_traits_3<Kernel>>;
  const auto count = static_cast<std::size_t>(state.range(0));
  const Scene& scene = sceneOf(count, Kinds::Points);
  Search::Tree tree;
  for (const SnapItem& item : scene.items) tree.insert({item.points[0].x(), item.points[0].y(), item.points[0].z()});
  tree.build();
  std::mt19937 random(3);
  std::vector<Vec3> hands;
  for (std::size_t i = 0; i < kTicks; ++i) hands.push_back(1.01 * onSphere(random));
  bench::Fastest ours, theirs;
  double distances = 0.0, theirDistances = 0.0;
  bool isSame = true;
  for (auto _ : state) {
    for (int turn = 0; turn < 3; ++turn) {
      distances = theirDistances = 0.0;
      ours.add(bench::secondsOf([&] {
        for (const Vec3& hand : hands) {
          const Vec3 p = hand - scene.field.origin();
          distances += scene.field.layer(0).nearest({p, p, 10.0 * kRadius, 1e300}).handDistance;
        }
      }));
      theirs.add(bench::secondsOf([&] {
        for (const Vec3& p : hands)
          theirDistances += std::sqrt(Search(tree, Kernel::Point_3(p.x(), p.y(), p.z()), 1).begin()->second);
      }));
    }
    isSame = isSame && std::abs(distances - theirDistances) <= 1e-9 * distances;
  }
  if (!isSame) return bars.failed(state, "nearest of " + std::to_string(count) + " points", "the distances differ");
  const double ticks = static_cast<double>(kTicks);
  state.counters["us"] = 1e6 * ours.seconds / ticks;
  state.counters["cgal_us"] = 1e6 * theirs.seconds / ticks;
}

}  // namespace

BENCHMARK(features)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Iterations(1);
BENCHMARK(crowd)->Arg(16)->Arg(32)->Arg(64)->Arg(128)->Arg(256)->Iterations(1);
BENCHMARK(curve)->Arg(10)->Arg(100)->Arg(1'000)->Iterations(1);
BENCHMARK(nearestPoint)->Arg(10'000)->Arg(1'000'000)->Iterations(1);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
