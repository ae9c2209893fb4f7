// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellDocument.h"
#include "tools/cell/HeldApproach.h"
#include "tools/cell/JointDragTool.h"
#include "tools/scene/BodySelection.h"
#include "tools/scene/FloorDrag.h"
#include "tools/scene/PlacingHandles.h"

namespace handwheel {

// Services that PlaceBodyTool uses.
struct PlaceBodyServices {
  JointDragTool::Pick pick;
  // Marks the collisions of a body at its pose, which is given in the frame of the base.
  std::function<void(DisplayModel& shown, const Body& moved)> mark;
  // Returns the number of the selected robot; nothing if none is selected. If robot and selectRobot are null, robots
  // cannot be placed.
  std::function<std::optional<std::size_t>()> robot = {};
  std::function<void(std::size_t robot)> selectRobot = {};
  // Marks the collisions of a robot that is moved as a whole by this displacement.
  std::function<void(DisplayModel& shown, std::size_t robot, const Pose& displacement)> markRobot = {};
  // Returns the name of the selected frame, which takes precedence over bodies and robots; empty: none. If null, frames
  // cannot be placed.
  std::function<std::string()> frame = {};
  HeldApproachServices approach = {};  // For the forces at a device
};

// Tool that places the selected body, or else the selected robot, by handles. Arrows along three axes move it, and
// rings about them turn it. The mouse drags a handle in steps unless Ctrl is held; a device drags it without steps. A
// body that is dragged directly, or a robot that is dragged by one of its links, moves in the horizontal plane, or up
// and down while Shift is held. A device that grabs the body itself moves and turns it freely. Typed numbers move and
// turn it from its present pose; they are previewed and take effect on commit. A selected frame is placed by its
// handles or numbers, even if it is attached to another object. Each release or commit is one edit. A body that a robot
// carries keeps its carrier; only its pose on the carrier changes. The robot whose base is the root of the cell has no
// handles, because all poses are measured from its base. A device is pushed away from what is near to the body or robot
// that it holds, by force and torque; a device that drags a handle, along or about its axis only.
class PlaceBodyTool : public Tool {
 public:
  // The selection must outlive the tool.
  PlaceBodyTool(RobotCellDocument& document, BodySelection& selection, PlaceBodyServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "place"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  std::vector<DeviceSpring> forces() const override;
  void documentChanged() override;
  bool remembersSettings() const override { return false; }  // The owner of the services keeps those of the force
  std::vector<std::string> needs() const override { return {"picking"}; }

  // Returns the handles of the subject; nothing unless exactly one body, or a robot or frame, is selected.
  std::optional<PlacingHandles> handles() const;

 private:
  enum class Frame { World, Body };
  enum class Centre { Middle, Origin };
  // State from press to release.
  struct Drag {
    std::optional<PlacingHandles::Handle> handle;  // Nothing: dragged directly, or held by a device
    PlacingHandles handles;                        // Handles at the press
    Pose start;                                    // Pose of the subject, in the base frame
    Vec3 grip;                                     // The grabbed point
    std::optional<Pose> hand;                      // Pose of a device at the press
    double travel = 0.0;                           // mm, rad
    std::optional<FloorDrag> floor = {};           // Set if dragged directly
    std::optional<DeviceSpring> push = {};         // The force at a device; nothing: nothing is near
  };

  // The body, robot or frame that is placed.
  struct Subject {
    std::string name;
    Pose pose;                              // In the base frame
    Box bounds = {};                        // In its own frame; empty: it is turned about its origin
    BodyPointer body = {};                  // Null: it is a robot or frame
    std::optional<std::size_t> robot = {};  // The number of the robot
    bool isFrame = false;
  };

  BodyPointer body() const;
  std::optional<Subject> subject() const;
  Pose carrier() const;  // Pose of the selected body's carrier, in the base frame
  Pose wanted() const;   // Previewed pose of the subject, in the base frame
  std::optional<Vec3> selectUnder(const PointerEvent& event);
  std::unique_ptr<Edit> editTo(const Subject& subject, const Pose& pose) const;
  std::shared_ptr<DisplayModel> shownAt(const Subject& subject, const Pose& pose) const;
  ToolReply press(const PointerEvent& event);
  void follow(const PointerEvent& event);
  void followFreely(const PointerEvent& event);
  void feel(const PointerEvent& event);
  void letGo();
  std::optional<double> travelUnder(const PointerEvent& event) const;
  double snapped(double travel, const PointerEvent& event) const;
  ToolReply commit(const Pose& pose, const QString& text);
  void measure(const PointerEvent& event);

  RobotCellDocument& m_document;
  BodySelection& m_selection;
  PlaceBodyServices m_services;
  HeldApproach m_approach;
  Frame m_frame = Frame::World;
  Centre m_centre = Centre::Middle;
  double m_length = 0.0;         // mm, length of the arrows; 0: as large as the body
  Vec3 m_moveBy = Vec3::Zero();  // mm, as typed
  Vec3 m_turnBy = Vec3::Zero();  // rad
  std::optional<PlacingHandles::Handle> m_hovered;
  std::optional<Drag> m_drag;
  Pose m_shown = Pose::Identity();  // Pose while it is dragged
};

}  // namespace handwheel
