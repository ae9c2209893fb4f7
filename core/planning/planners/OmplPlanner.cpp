// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/planners/OmplPlanner.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/PlannerData.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/est/EST.h>
#include <ompl/geometric/planners/kpiece/BKPIECE1.h>
#include <ompl/geometric/planners/prm/LazyPRM.h>
#include <ompl/geometric/planners/prm/PRM.h>
#include <ompl/geometric/planners/rrt/BiTRRT.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/geometric/planners/sbl/SBL.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

#include <algorithm>
#include <cassert>
#include <chrono>

namespace handwheel {

namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;

// The data that the states of OMPL and our checks share during one plan.
class OmplRun {
 public:
  OmplRun(const RobotScene& scene, const PlanSettings& settings, Progress progress, PlanResult& result)
      : m_scene(scene), m_settings(settings), m_progress(progress), m_result(result) {}

  // Slides count in metres, so that they weigh about as much as revolute joints.
  double scaleOf(Eigen::Index i) const { return m_scene.joint(i).isPrismatic ? 1e-3 : 1.0; }

  ArmValues valuesOf(const ob::State* state) const {
    const double* numbers = state->as<ob::RealVectorStateSpace::StateType>()->values;
    ArmValues values(m_scene.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = numbers[i] / scaleOf(i);
    return values;
  }

  void put(const ArmValues& values, ob::State* state) const {
    double* numbers = state->as<ob::RealVectorStateSpace::StateType>()->values;
    for (Eigen::Index i = 0; i < values.size(); ++i) numbers[i] = values[i] * scaleOf(i);
  }

  bool isFree(const ArmValues& values) {
    ++m_result.steps;
    return isFreeAt(m_scene, values, m_settings.check, &m_result.queries);
  }

  // Returns the share of the motion that is free from its start; 1: all of it.
  double freeShare(const ArmValues& from, const ArmValues& to, int attempts) {
    double share = 1.0;
    for (int i = 0; i < attempts; ++i) {
      MotionCheck motion(m_scene, from, from + share * (to - from), m_settings.check);
      while (motion.state() == MotionCheck::State::Open && !isOver()) motion.step(&m_result.queries);
      m_result.steps += motion.steps();
      if (motion.state() == MotionCheck::State::Free) return share;
      if (motion.state() == MotionCheck::State::Open) break;
      share *= 0.8 * motion.blockedAt();
    }
    return 0.0;
  }

  bool isOver() const {
    return m_progress.cancelled() || std::chrono::duration<double>(Clock::now() - m_begin).count() > m_settings.seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;

  const RobotScene& m_scene;
  const PlanSettings& m_settings;
  Progress m_progress;
  PlanResult& m_result;
  Clock::time_point m_begin = Clock::now();
};

class ProvenMotions : public ob::MotionValidator {
 public:
  ProvenMotions(const ob::SpaceInformationPtr& space, OmplRun& run) : ob::MotionValidator(space), m_run(run) {}

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    return m_run.freeShare(m_run.valuesOf(from), m_run.valuesOf(to), 1) == 1.0;
  }

  // Planners that extend a tree keep the free part of a blocked motion.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& lastValid) const override {
    constexpr int kAttempts = 3;
    const ArmValues begin = m_run.valuesOf(from), end = m_run.valuesOf(to);
    const double share = m_run.freeShare(begin, end, kAttempts);
    if (share == 1.0) return true;
    lastValid.second = share;
    if (lastValid.first) m_run.put(begin + share * (end - begin), lastValid.first);
    return false;
  }

 private:
  OmplRun& m_run;
};

ob::StateSpacePtr spaceOf(const RobotScene& scene, const OmplRun& run, const ArmValues& start, const ArmValues& goal) {
  ob::RealVectorBounds bounds(static_cast<unsigned>(scene.size()));
  for (Eigen::Index i = 0; i < scene.size(); ++i) {
    const JointRange range = planningRange(scene, i, start, goal);
    bounds.setLow(static_cast<unsigned>(i), range.low * run.scaleOf(i));
    bounds.setHigh(static_cast<unsigned>(i), range.high * run.scaleOf(i));
  }
  auto space = std::make_shared<ob::RealVectorStateSpace>(static_cast<unsigned>(scene.size()));
  space->setBounds(bounds);
  return space;
}

ob::PlannerPtr plannerFor(std::string_view id, const ob::SpaceInformationPtr& space) {
  if (id == "rrtconnect") return std::make_shared<og::RRTConnect>(space);
  if (id == "ompl-prm") return std::make_shared<og::PRM>(space);
  if (id == "lazyprm") return std::make_shared<og::LazyPRM>(space);
  if (id == "ompl-sbl") return std::make_shared<og::SBL>(space);
  if (id == "bitrrt") return std::make_shared<og::BiTRRT>(space);
  if (id == "bkpiece") return std::make_shared<og::BKPIECE1>(space);
  assert(id == "est");
  return std::make_shared<og::EST>(space);
}

// Proves the final path as a whole, independently of the planner.
bool isProven(const RobotScene& scene, const JointPath& path, const MotionCheckSettings& check,
              const Progress& progress) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    if (MotionCheck(scene, path[i - 1], path[i], check).run(progress) != MotionCheck::State::Free) return false;
  }
  return path.size() > 1;
}

}  // namespace

PlanResult planByOmpl(const RobotScene& scene, const ArmValues& start, const ArmValues& goal,
                      const PlanSettings& settings, std::string_view planner, Progress progress) {
  PlanResult result = checkedEnds(scene, start, goal, settings);
  if (result.outcome != PlanResult::Outcome::TimeOut) return result;
  if (start == goal) {  // some planners would search for ever
    result.path = {start, goal};
    result.outcome = PlanResult::Outcome::Solved;
    return result;
  }
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(std::max<std::uint_fast32_t>(1, static_cast<std::uint32_t>(settings.seed)));  // 0: none
  OmplRun run(scene, settings, progress, result);
  const auto space = std::make_shared<ob::SpaceInformation>(spaceOf(scene, run, start, goal));
  space->setStateValidityChecker([&](const ob::State* state) { return run.isFree(run.valuesOf(state)); });
  space->setMotionValidator(std::make_shared<ProvenMotions>(space, run));
  space->setup();
  const auto problem = std::make_shared<ob::ProblemDefinition>(space);
  ob::ScopedState<> first(space), last(space);
  run.put(start, first.get());
  run.put(goal, last.get());
  problem->setStartAndGoalStates(first, last);
  const ob::PlannerPtr made = plannerFor(planner, space);
  made->setProblemDefinition(problem);
  made->setup();
  made->solve(ob::PlannerTerminationCondition([&run] { return run.isOver(); }));
  ob::PlannerData data(space);
  made->getPlannerData(data);
  result.milestones = data.numVertices();
  made->clear();  // LazyPRM of OMPL 1.5 has no destructor that frees its states
  if (!problem->hasExactSolution()) {
    if (progress.cancelled()) result.outcome = PlanResult::Outcome::Cancelled;
    return result;
  }
  for (const ob::State* state : problem->getSolutionPath()->as<og::PathGeometric>()->getStates())
    result.path.push_back(run.valuesOf(state));
  result.path.front() = start;  // bit for bit
  result.path.back() = goal;
  if (isProven(scene, result.path, settings.check, progress))
    result.outcome = PlanResult::Outcome::Solved;
  else
    result.path.clear();
  if (result.path.empty() && progress.cancelled()) result.outcome = PlanResult::Outcome::Cancelled;
  return result;
}

}  // namespace handwheel
