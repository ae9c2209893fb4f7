// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/ThreadClock.h"
#include "bench/Bars.h"
#include "bench/SphereRobot.h"
#include "planning/PathShortcuts.h"
#include "planning/planners/Planners.h"
#include "planning/planners/Roadmap.h"

using namespace handwheel;

namespace {

bench::Bars bars;

constexpr std::size_t kEvery = 5;  // every n-th problem of each set is used to compare the planners: about a minute
constexpr double kSeconds = 2.0;   // for a path, by the clock
constexpr double kDense = 0.002;   // rad, joint motion between the configurations at which a path is checked again
constexpr int kShortcuts = 50;

const bench::SphereRobot* robot() {
  static const auto read = bench::SphereRobot::read();
  return read ? &*read : nullptr;
}

bool isSkipped(benchmark::State& state, const std::string& what) {
  if (robot()) return false;
  bars.missing(state, what, "HANDWHEEL_DATA is not set or has no planning/motionbenchmaker-ur5");
  return true;
}

// Measures this thread: none of the planners here uses another.
double cpuSecondsOf(auto&& work) {
  return 1e-3 * cpuMilliseconds(work);
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double each : values) sum += each;
  return sum / static_cast<double>(values.size());
}

ArmValues valuesOf(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

struct Figures {
  std::size_t problems = 0, withBlockedEnd = 0, unsolved = 0, colliding = 0;
  std::vector<std::string> blockedEnds;  // by their names
  std::vector<double> seconds, checks, distances, lengths;
  // Without an end that collides. Who counts these alone says nothing of the rest.
  std::size_t withFreeEnds() const { return problems - withBlockedEnd; }
};

// The ends that are themselves in collision: not by what the planners say.
std::vector<std::string> blockedEndsOf(const PlanningProblem& problem) {
  std::vector<std::string> blocked;
  const auto look = [&](const std::string& what, const std::vector<double>& numbers) {
    const ArmValues values = valuesOf(numbers);
    if (robot()->isColliding(problem, {values, values}, kDense)) blocked.push_back(what + " of " + problem.name);
  };
  look("start", problem.start);
  look("goal", problem.goal);
  return blocked;
}

Figures figuresOf(const char* planner, std::size_t every) {
  Figures figures;
  for (const PlanningSet& set : robot()->sets()) {
    for (std::size_t i = 0; i < set.problems.size(); i += every) {
      const PlanningProblem& problem = set.problems[i];
      const RobotScene scene = robot()->sceneOf(problem);
      PlanSettings settings;
      settings.seconds = kSeconds;
      PlanResult result;
      JointPath path;
      const double seconds = cpuSecondsOf([&] {
        result = planPath(scene, valuesOf(problem.start), valuesOf(problem.goal), settings, planner);
        path = shortened(scene, result.path, settings.check, kShortcuts, kSeconds, settings.seed);
      });
      ++figures.problems;
      const std::vector<std::string> blocked = blockedEndsOf(problem);
      figures.blockedEnds.insert(figures.blockedEnds.end(), blocked.begin(), blocked.end());
      figures.withBlockedEnd += blocked.empty() ? 0 : 1;
      if (result.outcome != PlanResult::Outcome::Solved) {
        figures.unsolved += blocked.empty() ? 1 : 0;
        continue;
      }
      const bool isSound = path.front() == valuesOf(problem.start) && path.back() == valuesOf(problem.goal);
      figures.colliding += !isSound || robot()->isColliding(problem, path, kDense) ? 1 : 0;
      figures.seconds.push_back(seconds);
      figures.checks.push_back(static_cast<double>(result.steps));
      figures.distances.push_back(static_cast<double>(result.queries.exact));
      figures.lengths.push_back(lengthOf(scene, path));
    }
  }
  return figures;
}

// Once for each planner, for the table and for the comparison.
const Figures& figures(const std::string& planner, std::size_t every) {
  static std::map<std::pair<std::string, std::size_t>, Figures> known;
  const auto found = known.find({planner, every});
  if (found != known.end()) return found->second;
  return known.emplace(std::pair(planner, every), figuresOf(planner.c_str(), every)).first->second;
}

void paths(benchmark::State& state) {
  if (isSkipped(state, "MotionBenchMaker, UR5")) return;
  const PlannerName& planner = planners()[static_cast<std::size_t>(state.range(0))];
  const std::string id = planner.id, what = "MotionBenchMaker, UR5, " + id;
  const bool isOurs = id == "sbl";
  for (auto _ : state) {
    const Figures& found = figures(id, isOurs ? 1 : kEvery);
    const auto all = static_cast<double>(found.problems), free = static_cast<double>(found.withFreeEnds());
    const double unsolved = 100.0 * bench::ratioTo(static_cast<double>(found.unsolved), free);
    const double unsolvedOfAll = 100.0 * bench::ratioTo(all - static_cast<double>(found.lengths.size()), all);
    const double ms = 1e3 * medianOf(found.seconds);
    bars.atMostOver(found.lengths.size(), what + ": colliding when checked every 0.002 rad", 0.0,
                    static_cast<double>(found.colliding));
    bars.tell(what + ": problems", all);
    bars.tell(what + ": with an end in collision", static_cast<double>(found.withBlockedEnd));
    bars.tell(what + ": not solved, of all, %", unsolvedOfAll);
    if (isOurs) {
      for (const std::string& end : found.blockedEnds) bars.tell("in collision itself: " + end, 1.0);
      bars.atMost(what + ": not solved, of those with free ends, %", 1.0, unsolved);
      bars.atMost(what + ": median, ms of CPU time", 10.0, ms);
    } else {
      bars.tell(what + ": not solved, of those with free ends, %", unsolved);
      bars.tell(what + ": median, ms of CPU time", ms);
    }
    bars.tell(what + ": mean length, rad", meanOf(found.lengths));
    bars.tell(what + ": mean of points that were looked at", meanOf(found.checks));
    bars.tell(what + ": mean of distances that were computed", meanOf(found.distances));
    state.counters["ms"] = ms;
  }
}

void checksBesideOmpl(benchmark::State& state) {
  if (isSkipped(state, "SBL beside OMPL's")) return;
  for (auto _ : state) {
    const Figures &own = figures("sbl", kEvery), &other = figures("ompl-sbl", kEvery);
    bars.atMost("SBL beside OMPL's: points that were looked at", 1.0,
                bench::ratioTo(meanOf(own.checks), meanOf(other.checks)));
    bars.atMost("SBL beside OMPL's: distances that were computed", 1.0,
                bench::ratioTo(meanOf(own.distances), meanOf(other.distances)));
  }
}

// The same cell again and again, with other ends near the first ones: with the roadmap that the plans before have left,
// and with one of its own for each.
void keptRoadmap(benchmark::State& state) {
  if (isSkipped(state, "PRM kept for the cell")) return;
  constexpr int kPlans = 10;
  for (auto _ : state) {
    double kept = 0.0, anew = 0.0, first = 0.0;
    for (const PlanningSet& set : robot()->sets()) {
      const PlanningProblem& problem = set.problems.front();
      const RobotScene scene = robot()->sceneOf(problem);
      Roadmap roadmap;
      PlanSettings settings;
      settings.seconds = 5.0 * kSeconds;
      const ArmValues start = valuesOf(problem.start), goal = valuesOf(problem.goal);
      first += cpuSecondsOf([&] { roadmap.plan(scene, start, goal, settings); });
      for (int i = 1; i <= kPlans; ++i) {
        ArmValues other = start;
        other[i % other.size()] += i % 2 ? 0.05 : -0.05;
        if (!isFreeAt(scene, other, settings.check)) continue;
        Roadmap own;
        kept += cpuSecondsOf([&] { roadmap.plan(scene, other, goal, settings); });
        anew += cpuSecondsOf([&] { own.plan(scene, other, goal, settings); });
      }
    }
    bars.tell("PRM: first plans of 7 cells, ms", 1e3 * first);
    bars.tell("PRM: later plans with the kept roadmap, ms", 1e3 * kept);
    bars.tell("PRM: the same without, ms", 1e3 * anew);
    bars.atMost("PRM kept for the cell: time to that without", 0.5, bench::ratioTo(kept, anew));
  }
}

}  // namespace

BENCHMARK(paths)->DenseRange(0, 2)->Iterations(1)->Unit(benchmark::kMillisecond);  // sbl, prm, rrtconnect
BENCHMARK(checksBesideOmpl)->Iterations(1)->Unit(benchmark::kMillisecond);
BENCHMARK(keptRoadmap)->Iterations(1)->Unit(benchmark::kMillisecond);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
