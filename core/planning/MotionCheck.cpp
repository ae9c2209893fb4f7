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

MotionCheck::MotionCheck(const RobotScene& scene, const ArmValues& from, const ArmValues& to,
                         const MotionCheckSettings& settings)
    : m_scene(&scene), m_from(from), m_to(to), m_way(to - from), m_settings(settings) {
  assert(from.size() == scene.size() && to.size() == scene.size());
  if (!from.allFinite() || !to.allFinite()) {
    m_state = State::Blocked;
    return;
  }
  m_open.push_back({0.0, 1.0});
  const RobotScene::Places places = scene.placesAt(from);
  for (std::uint32_t p = 0; p < scene.m_parts.size(); ++p)
    m_reach = std::max(m_reach, scene.speedOf(m_way, p, kNone, 0.5, places));
}

double MotionCheck::openLength() const {
  return m_open.empty() ? 0.0 : m_reach * (m_open.front().end - m_open.front().begin);
}

// Shortens the half interval that is free around the present point to what this distance allows; false: it keeps no
// clearance.
bool MotionCheck::cover(double distance, double clearance, double speed, double& half) const {
  const double room = distance - clearance;
  if (!(room > 0.5 * m_settings.resolution)) return false;
  if (speed * half >= room) half = room / speed;
  return true;
}

MotionCheck::State MotionCheck::step(QueryCounts* counts) {
  if (m_state != State::Open) return m_state;
  if (m_open.empty()) return m_state = State::Free;
  const Interval now = m_open.front();
  m_open.pop_front();
  ++m_steps;
  const double middle = 0.5 * (now.begin + now.end), whole = 0.5 * (now.end - now.begin);
  const ArmValues values = m_from + middle * m_way;
  const RobotScene::Places places = m_scene->placesAt(values);
  // More than what the motion needs is not asked for.
  const auto enough = [&](double clearance, double speed, double half) {
    return (clearance + speed * half) * (1.0 + RobotScene::kRounding) + m_settings.resolution;
  };
  const auto block = [&](const RobotScene::Nearest& by) {
    m_blockedAt = middle;
    m_blockedBy = by;
    m_open.clear();
    return m_state = State::Blocked;
  };
  // What stands during the motion is looked at once.
  const auto isKnown = [&](double speed) { return speed == 0.0 && m_steps > 1; };
  double half = whole;
  std::vector<double> speeds;  // of the parts, in the world
  speeds.reserve(m_scene->m_parts.size());
  for (std::uint32_t p = 0; p < m_scene->m_parts.size(); ++p) {
    const RobotScene::Part& part = m_scene->m_parts[p];
    speeds.push_back(m_scene->speedOf(m_way, p, kNone, whole, places));
    if (part.joint == kNone || isKnown(speeds[p])) continue;
    const auto found = m_scene->m_obstacles.distance(
        part.body, places.parts[p], enough(m_settings.clearance, speeds[p], half), part.leftOut, counts);
    if (!cover(found.distance, m_settings.clearance, speeds[p], half))
      return block({found.distance, part.link, kNone, found.owner});
  }
  for (const RobotScene::Pair& pair : m_scene->m_pairs) {
    // Relative to each other they are no faster than both together in the world.
    if (m_scene->areApart(pair, places,
                          enough(m_settings.ownClearance, speeds[pair.first] + speeds[pair.second], half)))
      continue;
    const double speed = m_scene->speedOf(m_way, pair.first, pair.common, half, places) +
                         m_scene->speedOf(m_way, pair.second, pair.common, half, places);
    if (isKnown(speed)) continue;
    const double distance = m_scene->pairDistance(pair, places, enough(m_settings.ownClearance, speed, half), counts);
    if (!cover(distance, m_settings.ownClearance, speed, half)) {
      const auto link = [&](std::uint32_t part) { return m_scene->m_parts[part].link; };
      return block({distance, link(pair.first), link(pair.second), kNone});
    }
  }
  if (half < whole) {
    m_open.push_back({now.begin, middle - half});
    m_open.push_back({middle + half, now.end});
  }
  if (m_open.empty()) m_state = State::Free;
  return m_state;
}

MotionCheck::State MotionCheck::run(QueryCounts* counts) {
  while (step(counts) == State::Open) {
  }
  return m_state;
}

}  // namespace handwheel
