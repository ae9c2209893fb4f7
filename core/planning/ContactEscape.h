// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ProximityQuery.h"
#include "planning/RobotScene.h"

#include <map>

namespace handwheel {

// A path of a robot out of contact, for a start that collides. It takes small steps in which no contact gets deeper and
// no new contact begins.
class ContactEscape {
 public:
  static constexpr double kLongestStep = 0.5;  // mm: the longest travel of a point of the robot

  // The scene must outlive it. O(pieces of the scene).
  explicit ContactEscape(const RobotScene& scene);

  // Returns true if the robot may move between these values, which move none of its points by more than kLongestStep.
  // resolution: mm; anything nearer than this counts as contact.
  bool mayGo(const ArmValues& from, const ArmValues& to, double resolution);

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> distances(const ArmValues& values, double reach);

  const RobotScene& m_scene;
  std::vector<std::uint32_t> m_joints;  // joint of the scene that carries each of the first bodies
  ProximityQuery m_query;
  std::vector<NearPair> m_near;
};

}  // namespace handwheel
