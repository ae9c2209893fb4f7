// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "collision/ProximityQuery.h"
#include "planning/RobotScene.h"

#include <map>

namespace handwheel {

// A check of small steps that lead a colliding robot out of contact. No existing contact may get deeper in a step, and
// no new contact may begin.
class ContactEscape {
 public:
  static constexpr double kLongestStep = 0.5;  // mm: the longest travel of a point of the robot in one step

  // Prepares the check for a scene, which must outlive this object. O(pieces of the scene).
  explicit ContactEscape(const RobotScene& scene);

  // Returns true if the robot may move between these values. Returns false if a point of it moves by more than
  // kLongestStep. resolution: the distance below which there is contact, mm.
  bool mayGo(const ArmValues& from, const ArmValues& to, double resolution);

 private:
  std::map<std::pair<std::uint32_t, std::uint32_t>, double> distances(const ArmValues& values, double reach);

  const RobotScene& m_scene;
  std::vector<std::uint32_t> m_joints;  // joint of the scene that carries each moving body of the query
  ProximityQuery m_query;
  std::vector<NearPair> m_near;
};

}  // namespace handwheel
