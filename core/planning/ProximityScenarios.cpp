// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/ProximityScenarios.h"

#include "base/ThreadClock.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace handwheel {

namespace {

constexpr std::size_t kMostContacts = 1'000'000;

// The query between the links of a robot and its obstacles, at joint values.
class PlacedQuery {
 public:
  explicit PlacedQuery(const RobotScene& scene)
      : m_scene(scene), m_query(scene.approachQuery(m_joints)), m_poses(static_cast<std::size_t>(scene.size())) {}

  ProximityQuery& at(const ArmValues& values) {
    m_scene.jointPoses(values, m_poses);
    for (std::uint32_t body = 0; body < m_joints.size(); ++body) m_query.place(body, m_poses[m_joints[body]]);
    return m_query;
  }

 private:
  const RobotScene& m_scene;
  std::vector<std::uint32_t> m_joints;  // joint that moves each of the first bodies
  ProximityQuery m_query;
  std::vector<Pose> m_poses;
};

double distanceAt(PlacedQuery& query, const ArmValues& values) {
  const auto found = query.at(values).closest();
  return found ? found->points.distance : std::numeric_limits<double>::infinity();
}

ArmValues anyValues(const RobotScene& scene, std::mt19937& random) {
  constexpr double kLongestSlide = 1e4;  // mm, of slides without limits
  ArmValues values(scene.size());
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const ArmJoint& joint = scene.joint(i);
    const double most = joint.isPrismatic ? kLongestSlide : M_PI;
    values[i] = std::lerp(std::max(joint.lower, -most), std::min(joint.upper, most),
                          static_cast<double>(random()) / 4294967296.0);
  }
  return values;
}

}  // namespace

ProximityScenario scenarioOf(double distance, double tolerance) {
  if (!(distance > 0.0)) return ProximityScenario::Colliding;
  return distance < tolerance ? ProximityScenario::Near : ProximityScenario::Apart;
}

std::optional<ArmValues> valuesInScenario(const RobotScene& scene, ProximityScenario scenario, double tolerance,
                                          Progress progress) {
  constexpr int kMostTries = 20'000;
  std::mt19937 random(7);
  PlacedQuery query(scene);
  for (int i = 0; i < kMostTries && !progress.cancelled(); ++i) {
    progress.set(static_cast<double>(i) / kMostTries);
    const ArmValues values = anyValues(scene, random);
    if (scenarioOf(distanceAt(query, values), tolerance) == scenario) return values;
  }
  return std::nullopt;
}

std::optional<ProximityCosts> measureProximity(const RobotScene& scene, const ArmValues& values, double tolerance,
                                               int steps, Progress progress) {
  constexpr double kSwing = 1e-3;      // rad, or mm of a slide
  constexpr double kStepAngle = 0.05;  // rad of the swing in a step
  ProximityCosts costs;
  std::vector<BodyContact> contacts;
  for (std::size_t which = 0; which < ProximityCosts::kQueries; ++which) {
    PlacedQuery placed(scene);
    std::vector<double> times;
    QueryCounts counts;
    for (int i = 0; i <= steps; ++i) {
      if (progress.cancelled()) return std::nullopt;
      progress.set((static_cast<double>(which) + static_cast<double>(i) / steps) / ProximityCosts::kQueries);
      // The last step is at the values themselves.
      ArmValues now = values;
      if (i < steps)
        for (Eigen::Index j = 0; j < now.size(); ++j)
          now[j] += kSwing * std::sin(kStepAngle * i * (1.0 + 0.1 * static_cast<double>(j)));
      const double spent = cpuMilliseconds([&] {
        ProximityQuery& query = placed.at(now);
        query.resetCounts();
        if (which == 0) {
          const auto found = query.closest();
          costs.distance = found ? found->points.distance : std::numeric_limits<double>::infinity();
        }
        if (which == 1) costs.isNear = query.isNearer(tolerance);
        if (which == 2) costs.isColliding = query.isOverlapping();
        if (which == 3) query.findContacts(0.0, kMostContacts, contacts);
        counts.volumes += query.counts().volumes;
        counts.pairs += query.counts().pairs;
      });
      times.push_back(1e3 * spent);
    }
    std::sort(times.begin(), times.end());
    const auto count = static_cast<double>(times.size());
    costs.queries[which] = {times[times.size() / 2], times.back(), static_cast<double>(counts.volumes) / count,
                            static_cast<double>(counts.pairs) / count};
  }
  costs.contacts = contacts.size();
  costs.scenario = scenarioOf(costs.distance, tolerance);
  return costs;
}

MeasuredScenario measuredScenario(const RobotScene& scene, const ArmValues& present,
                                  std::optional<ProximityScenario> wanted, const ProximityRequest& request,
                                  Progress progress) {
  constexpr double kSearch = 0.5;  // share of the progress
  MeasuredScenario one{wanted, present, std::nullopt};
  if (wanted) one.values = valuesInScenario(scene, *wanted, request.tolerance, progress.part(0.0, kSearch));
  if (one.values) {
    one.costs = measureProximity(scene, *one.values, request.tolerance, request.steps, progress.part(kSearch, 1.0));
  }
  return one;
}

}  // namespace handwheel
