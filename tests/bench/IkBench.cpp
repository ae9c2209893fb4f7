// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/RandomSequence.h"
#include "bench/Bars.h"
#include "bench/KdlArm.h"
#include "robot/arm/ClosedFormIk.h"
#include "robot/arm/ComparisonIk.h"
#include "robot/dh/DhTable.h"

#include <memory>

using namespace handwheel;

namespace {

bench::Bars bars;

// The protocol of the authors of TRAC-IK: poses that random values within the limits reach, each sought from the middle
// of the limits, to within a tolerance of each of the six numbers of the error (metres, rad), in a time.
constexpr std::size_t kPoses = 10'000;
constexpr double kTolerance = 1e-5, kSeconds = 5e-3;

struct Problem {
  std::string name;
  SerialArm arm;
  std::vector<Pose> tips;
  std::vector<ArmValues>
      nearby;       // starting values for each tip: up to 0.1 rad in each joint from those it was made from
  bool isPromised;  // else the figures are only shown
};

Problem problemOf(const std::string& name, const char* robot, double turn, bool isPromised) {
  std::vector<DhRow> rows;
  for (const DhJoint& joint : libraryTable(robot)->joints) {
    rows.push_back(joint);
    if (turn > 0.0) {
      rows.back().lower = -turn;
      rows.back().upper = turn;
    }
  }
  Problem made{name, armOf(rows), {}, {}, isPromised};
  RandomSequence random(42), aside(43);
  ArmValues values(made.arm.size());
  for (std::size_t i = 0; i < kPoses; ++i) {
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      const ArmJoint& joint = made.arm.joints()[static_cast<std::size_t>(k)];
      values[k] = random.between(joint.lower, joint.upper);
    }
    made.tips.push_back(made.arm.tipPose(values));
    for (double& each : values) each += aside.between(-0.1, 0.1);
    made.nearby.push_back(values);
  }
  return made;
}

const std::array<Problem, 4>& problems() {
  static const std::array<Problem, 4> all{
      problemOf("irb120", "irb120", 0.0, true), problemOf("irb2400", "irb2400", 0.0, true),
      problemOf("ur5, +-180 deg", "ur5", M_PI, true), problemOf("ur5, +-360 deg", "ur5", 2.0 * M_PI, false)};
  return all;
}

// Returns true if the values keep the limits and bring the tip there, judged from the pose alone: no entry of the
// difference of two rotations is larger than the angle between them, which is at most √3 of its largest component.
bool isThere(const Problem& problem, const ArmValues& values, const Pose& tip) {
  const Pose at = problem.arm.tipPose(values);
  const double offset = 1e-3 * (at.translation() - tip.translation()).cwiseAbs().maxCoeff();
  const double turn = (at.linear() - tip.linear()).cwiseAbs().maxCoeff();
  return problem.arm.isWithinLimits(values) && offset <= 1.01 * kTolerance &&
         turn <= 1.01 * std::sqrt(3.0) * kTolerance;
}

struct Figures {
  std::size_t solved = 0, wrong = 0;
  std::vector<double> times = {};  // us

  void add(double seconds, bool isSolved, bool isRight) {
    times.push_back(1e6 * seconds);
    solved += isSolved;
    wrong += isSolved && !isRight;
  }
  double share() const { return 100.0 * static_cast<double>(solved) / static_cast<double>(times.size()); }
  double mean() const {
    double sum = 0.0;
    for (const double each : times) sum += each;
    return sum / static_cast<double>(times.size());
  }
  double quantile(double share) const {
    std::vector<double> sorted = times;
    std::sort(sorted.begin(), sorted.end());
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
  }
};

void tell(const std::string& what, const Figures& figures) {
  bars.tell(what + ": solved, %", figures.share());
  bars.tell(what + ": mean, us", figures.mean());
  bars.tell(what + ": 99 % within, us", figures.quantile(0.99));
}

Figures ownFigures(const Problem& problem) {
  Figures figures;
  NumericalIkSettings settings;
  settings.tolerance = kTolerance;
  settings.seconds = kSeconds;
  const ArmValues middle = problem.arm.middle();
  for (const Pose& tip : problem.tips) {
    NumericalIkResult found;
    const double seconds = bench::secondsOf([&] { found = solvedNumerically(problem.arm, tip, middle, settings); });
    figures.add(seconds, found.isSolved, isThere(problem, found.values, tip));
  }
  return figures;
}

#ifdef HANDWHEEL_HAS_KDL

// `every`: of the poses; KDL's own method takes the whole time for most of them.
Figures kdlFigures(const Problem& problem, bench::KdlArm::Method method, std::size_t every) {
  Figures figures;
  bench::KdlArm kdl(problem.arm, method, kTolerance, kSeconds);
  for (std::size_t i = 0; i < problem.tips.size(); i += every) {
    std::optional<ArmValues> found;
    const double seconds = bench::secondsOf([&] { found = kdl.solved(problem.tips[i]); });
    figures.add(seconds, found.has_value(), found && isThere(problem, *found, problem.tips[i]));
  }
  return figures;
}

void compareToKdl(benchmark::State& state, const Problem& problem, const Figures& own) {
  constexpr std::size_t kEvery = 20;
  const Figures newton = kdlFigures(problem, bench::KdlArm::Method::Newton, kEvery);
  const Figures restarted = kdlFigures(problem, bench::KdlArm::Method::RestartedLevenberg, 1);
  tell(problem.name + ", KDL's NR_JL", newton);
  tell(problem.name + ", KDL's LMA with restarts", restarted);
  const double ratio = bench::ratioTo(own.mean(), restarted.mean());
  state.counters["ratio"] = ratio;
  bars.atMost(problem.name + ": mean to that of KDL's LMA with restarts", 0.5, ratio);
}

#else

void compareToKdl(benchmark::State&, const Problem&, const Figures&) {}

#endif

void numerical(benchmark::State& state) {
  const Problem& problem = problems()[static_cast<std::size_t>(state.range(0))];
  for (auto _ : state) {
    const Figures own = ownFigures(problem);
    const std::string what = problem.name + ", numerical";
    if (own.wrong > 0) return bars.failed(state, what, "what is said to be solved is not");
    state.counters["solved"] = own.share();
    state.counters["mean_us"] = own.mean();
    if (problem.isPromised) {
      bars.atMost(what + ": not solved, %", 0.0, 100.0 - own.share());
      bars.atMost(what + ": mean, us", 25.0, own.mean());
      bars.atMost(what + ": 99 % within, us", 200.0, own.quantile(0.99));
    } else {
      tell(what, own);
    }
    compareToKdl(state, problem, own);
  }
}

// IK1 and IK2 of He 2008 beside ours, by the protocol above, where what ends beyond the limits is not solved, and from
// nearby to the 0.001 rad of the thesis, which took 0.58 and 1.54 ms.
void comparison(benchmark::State& state) {
  const Problem& problem = problems()[static_cast<std::size_t>(state.range(0))];
  const auto ours = [](const SerialArm& arm, const Pose& tip, const ArmValues& start, NumericalIkSettings settings) {
    settings.mostStarts = 1;
    return solvedNumerically(arm, tip, start, settings);
  };
  const auto figuresOf = [&](const std::string& method, const auto& solved) {
    Figures far, near;
    for (std::size_t i = 0; i < problem.tips.size(); ++i) {
      const Pose& tip = problem.tips[i];
      const auto add = [&](Figures& figures, const ArmValues& start, double tolerance) {
        NumericalIkResult found;
        const double seconds =
            bench::secondsOf([&] { found = solved(problem.arm, tip, start, {.tolerance = tolerance}); });
        for (double& each : found.values) each = std::remainder(each, 2.0 * M_PI);
        figures.add(seconds, found.isSolved && problem.arm.isWithinLimits(found.values), true);
      };
      add(far, problem.arm.middle(), kTolerance);
      add(near, problem.nearby[i], 1e-3);
    }
    tell(problem.name + ", " + method + ", one start in the middle", far);
    tell(problem.name + ", " + method + ", from nearby to 0.001 rad", near);
  };
  for (auto _ : state) {
    figuresOf("ours", ours);
    figuresOf("IK1", solvedByJacobian);
    figuresOf("IK2", solvedByTaylor);
  }
}

void withoutKdl([[maybe_unused]] benchmark::State& state) {
  for (auto _ : state) {
#ifndef HANDWHEEL_HAS_KDL
    bars.skipped(state, "the same poses by KDL", "liborocos-kdl-dev is not installed");
#endif
  }
}

// All solutions of each pose; each has to be one, and the values that the pose was made from among them is what the
// tests show.
void closedForm(benchmark::State& state) {
  const Problem& problem = problems()[static_cast<std::size_t>(state.range(0))];
  const std::string what = problem.name + ", closed form, all solutions";
  const auto ik = ClosedFormIk::of(problem.arm);
  if (!ik) return bars.failed(state, what, "it has no closed form");
  const ArmValues middle = problem.arm.middle();
  IkSolutions solutions;
  std::size_t count = 0, missed = 0;
  for (const Pose& tip : problem.tips) {
    ik->solve(tip, middle, solutions);
    count += solutions.count;
    bool isReached = false;
    for (const IkSolutions::Solution& each : solutions) {
      const auto values = withinLimits(problem.arm, each.values, middle);
      isReached |= values && isThere(problem, *values, tip);
    }
    missed += !isReached;
  }
  if (missed > 0) return bars.failed(state, what, "a pose was missed");
  bench::Fastest fastest;
  for (auto _ : state) {
    const double seconds = bench::secondsOf([&] {
      for (const Pose& tip : problem.tips) {
        ik->solve(tip, middle, solutions);
        benchmark::DoNotOptimize(solutions.count);
      }
    });
    state.SetIterationTime(seconds);
    fastest.add(seconds);
  }
  const auto poses = static_cast<double>(problem.tips.size());
  state.counters["us"] = 1e6 * fastest.seconds / poses;
  bars.atMost(what + ", us", 3.0, 1e6 * fastest.seconds / poses);
  bars.tell(what + ", of a pose", static_cast<double>(count) / poses);
}

}  // namespace

BENCHMARK(numerical)->DenseRange(0, 3)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(comparison)->DenseRange(0, 2)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(withoutKdl)->Iterations(1);
BENCHMARK(closedForm)->DenseRange(0, 2)->Iterations(30)->UseManualTime()->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
