// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/HeldApproach.h"
#include "tools/cell/JointDragTool.h"
#include "tools/scene/BodyDragTool.h"

namespace handwheel {

// Tool that moves the links of a robot, and bodies beside it, by hand. A device that drags a body is pushed away from
// what is near to the body, in the directions of the drag.
class CellTool : public Tool {
 public:
  // Marks the collisions of the displayed cell: those of the robot at these joint values, and those of a body that is
  // being moved. moved: null if there is none.
  using Mark = std::function<void(DisplayModel& shown, const JointValues& joints, const Body* moved)>;
  // Called with the link of a robot that is pressed.
  using Pressed = std::function<void(std::uint32_t link)>;
  // The selection must outlive the tool.
  CellTool(RobotCellDocument& document, BodySelection& selection, JointDragTool::Pick pick, Mark mark = {},
           Pressed pressed = {}, HeldApproachServices approach = {});

  static std::span<const ToolKey> keys();
  std::string id() const override { return m_joints.id(); }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  std::vector<DeviceSpring> forces() const override;
  void documentChanged() override;
  std::vector<std::string> needs() const override { return m_joints.needs(); }

 private:
  std::vector<ToolAction> withPlacing(std::vector<ToolAction> actions) const;
  void feel(const PointerEvent& event);

  const RobotCellDocument& m_document;
  JointDragTool::Pick m_pick;
  Mark m_mark;
  Pressed m_pressed;
  BodySelection& m_selection;
  JointDragTool m_joints;
  BodyDragTool m_bodies;
  HeldApproach m_approach;
  std::optional<DeviceSpring> m_push;  // The force at a device; nothing: nothing is near
};

}  // namespace handwheel
