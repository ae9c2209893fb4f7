// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/RobotCellDocument.h"
#include "tools/cell/JointDragTool.h"
#include "tools/scene/BodySelection.h"
#include "tools/scene/FloorDrag.h"
#include "tools/scene/PlacingHandles.h"

namespace handwheel {

// Services that PlaceBodyTool uses.
struct PlaceBodyServices {
  JointDragTool::Pick pick;
  // Marks what collides while the body is there, in the frame of the base.
  std::function<void(DisplayModel& shown, const Body& moved)> mark;
  // The number of the selected robot; none: no robot is. Null, both: robots are not placed.
  std::function<std::optional<std::size_t>()> robot = {};
  std::function<void(std::size_t robot)> selectRobot = {};
  // Marks what collides with a robot that is moved so far as a whole.
  std::function<void(DisplayModel& shown, std::size_t robot, const Pose& way)> markRobot = {};
  // The name of the selected frame, which is placed before all else; empty: none is. Null: frames are not placed.
  std::function<std::string()> frame = {};
};

// Tool that places the selected body by handles. Or else the selected robot by its base: arrows along three axes move
// it, rings about them turn it, by the mouse or a device, in steps unless Ctrl is held. Dragged by itself, as by any
// link of the robot, it moves over the horizontal plane, with Shift up and down. A device that grabs the body itself
// moves and turns it freely. Numbers that are typed move and turn it from where it is; they are shown and hold when
// they are committed. A selected frame is placed by its handles or numbers, whatever carries it. Each release or commit
// is one edit. A body that the robot carries is placed on its carrier. The robot on the root has no handles, as
// everything is measured from its base.
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
  void documentChanged() override;
  bool remembersSettings() const override { return false; }
  std::vector<std::string> needs() const override { return {"picking"}; }

  // Those of what is placed; none: neither a body is selected alone, nor a robot.
  std::optional<PlacingHandles> handles() const;

 private:
  enum class Frame { World, Body };
  enum class Centre { Middle, Origin };
  // From press to release.
  struct Drag {
    std::optional<PlacingHandles::Handle> handle;  // none: it is dragged by itself, or a device holds it
    PlacingHandles handles;                        // at the press
    Pose start;                                    // of what is placed, in the base
    Vec3 grip;                                     // where it was grabbed
    std::optional<Pose> hand;                      // of a device, at the press
    double way = 0.0;                              // mm, rad
    std::optional<FloorDrag> floor = {};           // dragged by itself
  };

  // What is placed.
  struct Subject {
    std::string name;
    Pose pose;                              // in the base
    Box bounds = {};                        // in its own frame; empty: it is turned about its origin
    BodyPointer body = {};                  // null: it is a robot or frame
    std::optional<std::size_t> robot = {};  // its number
    bool isFrame = false;
  };

  BodyPointer body() const;
  std::optional<Subject> subject() const;
  Pose carrier() const;  // of the selected body, in the base
  Pose wanted() const;   // of what is placed in the base, as it is shown
  std::optional<Vec3> selectUnder(const PointerEvent& event);
  std::unique_ptr<Edit> editTo(const Subject& subject, const Pose& pose) const;
  std::shared_ptr<DisplayModel> shownAt(const Subject& subject, const Pose& pose) const;
  ToolReply press(const PointerEvent& event);
  void follow(const PointerEvent& event);
  void followFreely(const PointerEvent& event);
  std::optional<double> wayUnder(const PointerEvent& event) const;
  double snapped(double way, const PointerEvent& event) const;
  ToolReply commit(const Pose& pose, const QString& text);
  void measure(const PointerEvent& event);

  RobotCellDocument& m_document;
  BodySelection& m_selection;
  PlaceBodyServices m_services;
  Frame m_frame = Frame::World;
  Centre m_centre = Centre::Middle;
  double m_length = 0.0;         // mm, of the arrows; 0: as large as the body
  Vec3 m_moveBy = Vec3::Zero();  // mm, as typed
  Vec3 m_turnBy = Vec3::Zero();  // rad
  std::optional<PlacingHandles::Handle> m_hovered;
  std::optional<Drag> m_drag;
  Pose m_shown = Pose::Identity();  // while it is dragged
};

}  // namespace handwheel
