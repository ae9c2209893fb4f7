// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellSnapshot.h"
#include "document/scene/BodyEdit.h"

#include <optional>

namespace handwheel {

// An edit that replaces the robots of a cell, and what depends on them. That is joint values, plans, and the bodies
// that they carry.
class RobotsEdit : public Edit {
 public:
  // bodies: that change with it. moved: the robot that is moved, if nothing else is changed.
  RobotsEdit(RobotCellSnapshot other, std::vector<BodyEdit::Change> bodies, std::optional<std::size_t> moved);

  void exchange(Document& document) override;
  bool absorb(const Edit& later) override;  // that only moves the same robot
  std::size_t bytes() const override;

 private:
  std::shared_ptr<const CellRobot> m_robot;
  JointValues m_joints;
  std::shared_ptr<const CellPlans> m_plans;
  std::optional<BodyEdit> m_bodies;
  std::optional<std::size_t> m_moved;
};

}  // namespace handwheel
