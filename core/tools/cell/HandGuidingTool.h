// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellScene.h"
#include "document/cell/RobotCellDocument.h"
#include "planning/ApproachForce.h"
#include "planning/GuideCurve.h"
#include "planning/Teleoperation.h"
#include "tools/ToolKey.h"

#include <functional>

namespace handwheel {

// Measurements of an attempt to lead the tool along a path by hand. Help is what assisted it (He 2008, chapter 6: the
// three are compared).
struct HandGuidingTrial {
  enum class Help { Eyes, Force, Fixture };  // a fixture has force, too
  std::string path;
  Help help = Help::Eyes;
  FollowingStatistics figures;
};

// Services that HandGuidingTool uses.
struct HandGuidingServices {
  // The cell as it is now, prepared for planning; null while it is being prepared.
  std::function<std::shared_ptr<const CellScene>()> scene;
  // Marks what collides where the robot stands.
  std::function<void(DisplayModel& shown, const JointValues& joints)> mark;
  // Adds the configuration of the document to the selected path, or to a new one.
  std::function<void()> addPlace;
  // s, of a clock that does not go back.
  std::function<double()> time;
  // The way of the tool's centre point along a path of the cell; null while that is being found, or there is none.
  std::function<std::shared_ptr<const GuideCurve>(const std::string& path)> guide;
  double tolerance = DistanceForceSettings().tolerance;    // mm, of distances that are felt
  double ikTolerance = TeleoperationSettings().tolerance;  // m, rad
  std::vector<HandGuidingTrial>* trials = nullptr;         // what was tried in this document; outlives the tool
};

// Tool that guides a robot by hand at its tool. The arm follows: never through anything, nor beyond a limit. The hand
// takes over wherever it is, and feels what holds the robot back and what it comes near to. With the mouse the tool
// moves in the plane of the view, or, with Shift, turns. A path of the cell can be followed, with a virtual fixture
// that draws the tool to it; how well that went is measured. Places of paths are pulled in the same way: a press near
// the tool's centre point at one, to which a device is drawn, takes that. Letting go commits one edit.
class HandGuidingTool : public Tool {
 public:
  HandGuidingTool(RobotCellDocument& document, HandGuidingServices services);

  static std::span<const ToolKey> keys();
  std::string id() const override { return "lead"; }
  ToolReply pointer(const PointerEvent& event) override;
  ToolReply perform(std::string_view action) override;
  std::vector<ToolAction> actions() const override;
  ToolPreview preview() const override;
  std::vector<Property> settings() const override;
  void setSetting(std::string_view id, const PropertyValue& value) override;
  std::vector<DeviceSpring> forces() const override;
  void settle() override;
  void documentChanged() override;

  bool isLeading() const { return m_guidance != nullptr; }
  // The joint values: those that the robot is led to, otherwise those of the document.
  JointValues joints() const;
  // The tool's centre point there, in the frame of the base; none while the cell is not prepared.
  std::optional<Pose> toolPose() const;

 private:
  enum class Way { Tool, Joints, Places };  // what follows the hand
  // A place of a path: their numbers in the plans, and the tool's centre point there, in the frame of the base.
  struct PathPlace {
    std::size_t path, place;
    Vec3 point;
  };

  // From press to release.
  struct Guidance;

  ToolReply press(const PointerEvent& event);
  void begin(const PointerEvent& event);
  void beginAt(const PointerEvent& event, const std::shared_ptr<const CellScene>& scene, const ArmValues& start);
  ToolReply takePlace(const PointerEvent& event);
  void setPlace(const Guidance& pulled);
  const std::vector<PathPlace>& places();
  std::optional<PathPlace> placeNear(const PointerEvent& event);
  void takeGuide();
  void follow(const PointerEvent& event);
  void leadJoints(const Pose& hand);
  Pose wantedPose(const PointerEvent& event) const;
  ToolReply release();
  std::shared_ptr<const GuideCurve> guide() const;  // null: none, or not yet
  std::vector<std::string> pathNames() const;
  void addFigures(std::vector<Property>& all) const;

  RobotCellDocument& m_document;
  HandGuidingServices m_services;
  std::shared_ptr<Guidance> m_guidance;  // null: nothing is led
  std::string m_path;                    // that is to be followed; empty: none
  Way m_way = Way::Tool;
  double m_scale = 1.0;         // mm of the tool to a mm of the hand
  bool m_turns = true;          // the tool turns with the hand
  bool m_isFelt = true;         // the hand feels the robot
  double m_largestForce = 4.0;  // N
  double m_reach = 10.0;        // mm: what is nearer pushes the hand away
  double m_snapDistance = 0.0;  // mm; 0: no fixture
  double m_grasp = 15.0;        // mm around a place in which it is taken
  // All that can be pulled, of these plans, scene and path.
  std::vector<PathPlace> m_places;
  std::shared_ptr<const CellPlans> m_placesOf;
  std::weak_ptr<const CellScene> m_placesIn;
  std::string m_placesAlong;
  std::optional<PathPlace> m_near;  // that would be taken,
  std::optional<Vec3> m_tip;        // and where a device is that it draws
};

}  // namespace handwheel
