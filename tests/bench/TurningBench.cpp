// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "bench/SweptSection.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "machining/TurningFidelity.h"
#include "machining/TurningPass.h"

using namespace handwheel;

namespace {

constexpr StockCylinder kBenchBar{50.0, 100.0, 0.0};

bench::Bars bars;

// A shaft with two shoulders, a cone, a ball end, a groove and a stepped bore; at most `step` (mm) from point to point.
std::vector<TurningPass> scriptedPasses(double step) {
  std::vector<TurningPass> passes;
  const auto add = [&](double nose, TurningSide side, const std::vector<ProfilePoint>& corners) {
    TurningPass pass;
    pass.noseRadius = nose;
    pass.side = side;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      const int steps = std::max(1, static_cast<int>((corners[i + 1] - corners[i]).norm() / step));
      for (int k = 0; k < steps; ++k)
        pass.path.push_back(corners[i] + double(k) / steps * (corners[i + 1] - corners[i]));
    }
    pass.path.push_back(corners.back());
    pass.times.assign(pass.path.size(), 0.0);
    passes.push_back(std::move(pass));
  };
  const TurningSide outside = TurningSide::Outside;
  add(0.8, outside, {{26.0, 104.0}, {22.8, 104.0}, {22.8, 40.0137}, {28.0, 40.0137}});
  add(0.4, outside, {{28.0, 104.0}, {18.4, 104.0}, {18.4, 70.0071}, {23.4, 67.0}, {28.0, 67.0}});
  add(0.4, outside, {{28.0, 55.0033}, {17.4, 55.0033}, {28.0, 55.0033}});
  std::vector<ProfilePoint> ball;
  for (int i = 0; i <= 90; ++i) {
    const double angle = 0.5 * M_PI * (1.0 - i / 90.0);
    ball.emplace_back(18.8 * std::cos(angle), 82.0 + 18.8 * std::sin(angle));
  }
  ball.emplace_back(28.0, 82.0);
  add(0.8, outside, ball);
  add(0.4, TurningSide::Bore, {{4.6, -2.0}, {4.6, 30.0049}, {0.0, 30.0049}});
  add(0.4, TurningSide::Bore, {{9.6, -2.0}, {9.6, 12.0111}, {4.0, 12.0111}});
  return passes;
}

// Measures the distance between each boundary of the profile and the polygons.
void accuracy(benchmark::State& state) {
  for (auto _ : state) {
    TurnedProfile profile(kBenchBar, turnSpacingSetting().standard);
    bench::SweptSection section(0.5 * kBenchBar.diameter, kBenchBar.length);
    for (const TurningPass& pass : scriptedPasses(1e9)) {
      cut(profile, pass);
      section.cut(pass);
    }
    const bench::SectionDistance distance = section.distanceTo(profile);
    bars.atMost("profile from swept polygons of CGAL, mm", 0.01, distance.smooth);
    bars.atMost("the same at shoulders, mm", 0.02, distance.atShoulders);
    const double removed = kBenchBar.volume() - section.volume();
    bars.atMost("removed volume, to that of the polygons, share", 1e-3,
                std::abs((kBenchBar.volume() - profile.volume()) / removed - 1.0));
  }
}

// Each step of a pass: cut, tessellate what changed, hand the blocks over. The worst of all steps, in CPU time.
void changedRows(benchmark::State& state) {
  for (auto _ : state) {
    double worst = 0.0, sum = 0.0;
    int steps = 0;
    std::vector<double> each;
    for (int run = 0; run < 3; ++run) {
      TurnedProfile profile(kBenchBar, turnSpacingSetting().standard);
      TurnedSurface surface(profile, 0.01);
      std::size_t k = 0;
      for (const TurningPass& pass : scriptedPasses(0.1)) {
        for (std::size_t i = 1; i < pass.path.size(); ++i, ++k) {
          const double ms = cpuMilliseconds([&] {
            surface.update(profile, cut(profile, pass, pass.path[i - 1], pass.path[i]));
            benchmark::DoNotOptimize(displayOf(surface, 0.0));
          });
          if (run == 0)
            each.push_back(ms);
          else
            each[k] = std::min(each[k], ms);
        }
      }
    }
    for (const double ms : each) {
      worst = std::max(worst, ms);
      sum += ms;
      ++steps;
    }
    bars.atMost("changed rows tessellated and handed over, worst step, ms of CPU time", 2.0, worst);
    bars.tell("the same on average, ms", sum / steps);
  }
}

}  // namespace

BENCHMARK(accuracy)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(changedRows)->Iterations(1)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
