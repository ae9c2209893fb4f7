// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"
#include "document/scene/BodyEdit.h"

#include <optional>

namespace handwheel {

// An edit that replaces the robots of a cell and everything that depends on them. This covers the joint values, the
// plans, and the bodies that the robots carry.
class RobotsEdit : public Edit {
 public:
  // bodies: the bodies that change together with the robots. moved: the number of the robot, if moving it is the only
  // change.
  RobotsEdit(RobotCellSnapshot other, std::vector<BodyEdit::Change> bodies, std::optional<std::size_t> moved);

  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;  // absorbs only an edit that moves the same robot
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const CellRobot> m_robot;
  JointValues m_joints;
  std::shared_ptr<const CellPlans> m_plans;
  std::optional<BodyEdit> m_bodies;
  std::optional<std::size_t> m_moved;
};

}  // namespace handwheel
