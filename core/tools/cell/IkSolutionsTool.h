// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellReach.h"
#include "document/cell/RobotCellDocument.h"
#include "tools/ToolKey.h"

#include <functional>

namespace handwheel {

// Services that IkSolutionsTool uses.
struct IkSolutionsServices {
  // Returns the present cell prepared for planning; null while it is being prepared.
  std::function<std::shared_ptr<const CellScene>()> scene;
  // Marks the collisions of the displayed robot at these joint values.
  std::function<void(DisplayModel& shown, const JointValues& joints)> mark;
};

// Tool that shows all inverse kinematics solutions for a pose of the arm's tool. The pose is the present one, or is
// typed by the user. The user chooses a solution from a list and sees it; committing moves the robot to it. On a device
// the first button goes to the next solution, the second commits.
class IkSolutionsTool : public Tool {
 public:
  IkSolutionsTool(RobotCellDocument& document, IkSolutionsServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "ways"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  bool remembersSettings() const override { return false; }
  void documentChanged() override;

  const Pose& pose() const { return m_pose; }
  std::size_t chosen() const { return m_chosen; }

 private:
  const std::vector<CellIkSolution>& solutions() const;
  const CellIkSolution* solution() const;  // The chosen solution; null: there is none
  bool isThere() const;                    // True if the robot has the joint values of the chosen solution
  ToolReply choose(std::size_t solution);
  ToolReply commit();
  void forgetSolutions();

  RobotCellDocument& m_document;
  IkSolutionsServices m_services;
  Pose m_pose;  // The examined pose of the tool centre point
  std::size_t m_chosen = 0;
  // The solutions for m_pose in m_scene.
  mutable std::shared_ptr<const CellScene> m_scene;
  mutable std::vector<CellIkSolution> m_solutions;
};

}  // namespace handwheel
