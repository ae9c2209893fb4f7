// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/MotionCheck.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace handwheel {

RobotScene::Nearest blockerAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
                              QueryCounts* counts) {
  const double margin = 0.5 * settings.resolution;
  return scene.tooNear(values, settings.clearance + margin, settings.ownClearance + margin, counts);
}

bool isFreeAt(const RobotScene& scene, const ArmValues& values, const MotionCheckSettings& settings,
              QueryCounts* counts) {
  if (!scene.isCouplingWithin(values)) return false;
  const double margin = 0.5 * settings.resolution;
  return scene.isFree(values, settings.clearance + margin, settings.ownClearance + margin, counts);
}

MotionCheck::MotionCheck(const RobotScene& scene, const ArmValues& from, const ArmValues& to,
                         const MotionCheckSettings& settings)
    : m_scene(&scene), m_from(from), m_to(to), m_displacement(to - from), m_settings(settings) {
  assert(from.size() == scene.size() && to.size() == scene.size());
  if (!from.allFinite() || !to.allFinite()) {
    m_state = State::Blocked;
    return;
  }
  m_open.push_back({0.0, 1.0, 0});
  for (Eigen::Index i = 0; i < m_displacement.size(); ++i) {
    const auto& joint = scene.m_joints[static_cast<std::size_t>(i)];
    m_reach += std::abs(m_displacement[i]) * (joint.joint.isPrismatic ? 1.0 : joint.reach);
  }
}

double MotionCheck::openLength() const {
  return m_open.empty() ? 0.0 : m_reach * (m_open.front().end - m_open.front().begin);
}

// Shortens the free half interval around the present point to the part that this distance proves. Returns false if the
// clearance is violated.
bool MotionCheck::cover(double distance, double clearance, double speed, double& half) const {
  const double room = distance - clearance;
  if (!(room > 0.5 * m_settings.resolution)) return false;
  if (speed * half >= room) half = room / speed;
  return true;
}

// Returns the largest distance that the motion needs; no query asks for more.
double MotionCheck::enough(double clearance, double speed, double half) const {
  return (clearance + speed * half) * (1.0 + RobotScene::kRounding) + m_settings.resolution;
}

MotionCheck::Finding MotionCheck::cover(const RobotScene::Group& group, const Look& look, double& half) {
  if (group.joint == kNone) return Finding::Clear;  // bodies that do not move are as near as the cell makes it
  const RobotScene& scene = *m_scene;
  const double clearance = m_settings.clearance;
  const double fastest =
      scene.speedOf(m_displacement, group.joint, group.centre, group.radius, kNone, look.whole, look.poses);
  const auto obstacles = scene.near(group, look.poses, enough(clearance, fastest, look.whole), look.counts);
  if (obstacles.empty()) return Finding::Clear;
  for (std::uint32_t p = group.begin; p < group.end; ++p) {
    const RobotScene::Part& part = scene.m_parts[p];
    const double speed =
        scene.speedOf(m_displacement, part.joint, part.body.centre(), part.body.radius(), kNone, half, look.poses);
    const auto found = scene.m_obstacles.distance(part.body, look.poses.of(part.joint), enough(clearance, speed, half),
                                                  part.leftOut, obstacles, look.counts);
    if (cover(found.distance, clearance, speed, half)) continue;
    m_blockedBy = {found.distance, part.link, kNone, found.owner};
    return Finding::Blocked;
  }
  return half < look.whole ? Finding::Near : Finding::Clear;
}

MotionCheck::Finding MotionCheck::cover(const RobotScene::GroupPair& pair, const Look& look, double& half) {
  const RobotScene& scene = *m_scene;
  const double clearance = m_settings.ownClearance;
  // The relative speed is at most the sum of both.
  const auto speedOf = [&](std::uint32_t joint, const Vec3& centre, double radius, double during) {
    return scene.speedOf(m_displacement, joint, centre, radius, pair.common, during, look.poses);
  };
  const RobotScene::Group &first = scene.m_groups[pair.first], &second = scene.m_groups[pair.second];
  const double fastest = speedOf(first.joint, first.centre, first.radius, look.whole) +
                         speedOf(second.joint, second.centre, second.radius, look.whole);
  if (scene.areApart(pair, look.poses, enough(clearance, fastest, look.whole))) return Finding::Clear;
  for (std::uint32_t i = pair.begin; i < pair.end; ++i) {
    const RobotScene::Part &a = scene.m_parts[scene.m_pairs[i].first], &b = scene.m_parts[scene.m_pairs[i].second];
    const double speed = speedOf(a.joint, a.body.centre(), a.body.radius(), half) +
                         speedOf(b.joint, b.body.centre(), b.body.radius(), half);
    const double distance =
        scene.pairDistance(scene.m_pairs[i], look.poses, enough(clearance, speed, half), look.counts);
    if (cover(distance, clearance, speed, half)) continue;
    m_blockedBy = {distance, a.link, b.link, kNone};
    return Finding::Blocked;
  }
  return half < look.whole ? Finding::Near : Finding::Clear;
}

MotionCheck::Finding MotionCheck::coverSubject(std::uint32_t subject, const Look& look, double& half) {
  const std::size_t groups = m_scene->m_groups.size();
  return subject < groups ? cover(m_scene->m_groups[subject], look, half)
                          : cover(m_scene->m_groupPairs[subject - groups], look, half);
}

MotionCheck::State MotionCheck::step(QueryCounts* counts) {
  if (m_state != State::Open) return m_state;
  if (m_open.empty()) return m_state = State::Free;
  std::pop_heap(m_open.begin(), m_open.end());
  const Interval now = m_open.back();
  m_open.pop_back();
  const double middle = 0.5 * (now.begin + now.end);
  Look look;
  look.whole = 0.5 * (now.end - now.begin);
  look.counts = counts;
  m_scene->posesAt(m_from + middle * m_displacement, look.poses);
  double half = look.whole;  // half of the free interval around the middle
  std::uint64_t suspects = 0;
  constexpr std::size_t kBits = 63;  // groups beyond these share one bit
  const auto bitOf = [](std::size_t suspect) { return std::uint64_t{1} << (suspect < kBits ? suspect : kBits); };
  const bool isFirst = m_steps++ == 0;
  const std::size_t count = isFirst ? m_scene->m_groups.size() + m_scene->m_groupPairs.size() : m_suspects.size();
  for (std::size_t i = 0; i < count; ++i) {
    if (!isFirst && !(now.suspects & bitOf(i))) continue;
    const std::uint32_t subject = isFirst ? static_cast<std::uint32_t>(i) : m_suspects[i];
    const Finding finding = coverSubject(subject, look, half);
    if (finding == Finding::Clear) continue;
    if (finding == Finding::Blocked) {
      m_blockedAt = middle;
      m_open.clear();
      return m_state = State::Blocked;
    }
    suspects |= bitOf(isFirst ? m_suspects.size() : i);
    if (isFirst) m_suspects.push_back(subject);
  }
  if (half < look.whole) {
    open({now.begin, middle - half, suspects});
    open({middle + half, now.end, suspects});
  }
  if (m_open.empty()) m_state = State::Free;
  return m_state;
}

void MotionCheck::open(const Interval& interval) {
  m_open.push_back(interval);
  std::push_heap(m_open.begin(), m_open.end());
}

MotionCheck::State MotionCheck::run(const Progress& progress, QueryCounts* counts) {
  while (!progress.cancelled() && step(counts) == State::Open) {
  }
  return m_state;
}

}  // namespace handwheel
