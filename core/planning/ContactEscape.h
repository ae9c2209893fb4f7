// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ProximityQuery.h"
#include "planning/RobotScene.h"

#include <map>

namespace handwheel {

// A path of a robot out of contact, where no motion can be proven free. Small steps on which nothing that it meets gets
// deeper, and nothing else is reached.
class ContactEscape {
 public:
  static constexpr double kLongestStep = 0.5;  // mm that a point of the robot may move

  // The scene must outlive it. O(pieces of the scene).
  explicit ContactEscape(const RobotScene& scene);

  // Whether the robot may go from one place to another, no point of it further than kLongestStep. resolution: mm; what
  // is nearer than this counts as met.
  bool mayGo(const ArmValues& from, const ArmValues& to, double resolution);

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> distances(const ArmValues& values, double reach);

  const RobotScene& m_scene;
  std::vector<std::uint32_t> m_joints;  // of the scene, which carries each of the first bodies
  ProximityQuery m_query;
  std::vector<NearPair> m_near;
};

}  // namespace handwheel
