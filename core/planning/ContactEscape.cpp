// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/ContactEscape.h"

#include <algorithm>

namespace handwheel {

namespace {

using Pairs = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;

// Returns true if no pair gets nearer. before, after: distances of pairs, negative for penetrations; pairs beyond the
// reach are missing. travel: mm that two bodies of a pair may have approached each other.
bool noneComesNearer(const Pairs& before, const Pairs& after, double travel, double resolution) {
  return std::ranges::all_of(after, [&](const auto& pair) {
    const auto found = before.find(pair.first);
    if (found == before.end() || pair.second >= found->second) return true;
    const bool mayHaveMet = found->second <= std::max(travel, resolution) || pair.second <= resolution;
    return !mayHaveMet;
  });
}

}  // namespace

ContactEscape::ContactEscape(const RobotScene& scene) : m_scene(scene), m_query(scene.approachQuery(m_joints)) {}

Pairs ContactEscape::distances(const ArmValues& values, double reach) {
  std::array<Pose, kMostArmJoints> poses;
  const std::span<Pose> placed(poses.data(), static_cast<std::size_t>(m_scene.size()));
  m_scene.jointPoses(values, placed);
  for (std::uint32_t body = 0; body < m_joints.size(); ++body) m_query.place(body, placed[m_joints[body]]);
  m_query.findNear(reach, m_near);
  Pairs pairs;
  for (const NearPair& near : m_near) pairs[{near.bodies.first, near.bodies.second}] = near.points.distance;
  return pairs;
}

bool ContactEscape::mayGo(const ArmValues& from, const ArmValues& to, double resolution) {
  const double travel = m_scene.travelBound(from, (to - from).cwiseAbs());
  if (!(travel <= kLongestStep)) return false;
  const double reach = 2.0 * travel + resolution;
  if (!noneComesNearer(distances(from, reach), distances(to, reach), travel, resolution)) return false;
  // Both bodies of a pair of links move.
  const auto links = [&](const ArmValues& values) {
    Pairs pairs;
    for (const RobotScene::Nearest& each : m_scene.allTooNear(values, 0.0, reach)) {
      if (each.otherLink != kNone) pairs[std::minmax(each.link, each.otherLink)] = each.distance;
    }
    return pairs;
  };
  return noneComesNearer(links(from), links(to), 2.0 * travel, resolution);
}

}  // namespace handwheel
