// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellScene.h"
#include "document/cell/RobotCellDocument.h"
#include "planning/ApproachForce.h"
#include "planning/GuideCurve.h"
#include "planning/Teleoperation.h"
#include "tools/ToolKey.h"
#include "tools/cell/ApproachSettings.h"

#include <functional>

namespace handwheel {

// Measurements of an attempt to lead the tool along a path by hand. help: the assistance (He 2008, chapter 6, compares
// the three kinds).
struct HandGuidingTrial {
  enum class Help { Eyes, Force, Fixture };  // Eyes: no assistance; Fixture: pulls the tool to the path
  std::string path;
  Help help = Help::Eyes;
  FollowingStatistics figures;
};

// Services that HandGuidingTool uses.
struct HandGuidingServices {
  // Returns the present cell prepared for planning; null while it is being prepared.
  std::function<std::shared_ptr<const CellScene>()> scene;
  // Marks the collisions of the displayed robot at these joint values.
  std::function<void(DisplayModel& shown, const JointValues& joints)> mark;
  // Adds the configuration of the document to the selected path, or to a new one.
  std::function<void()> addWaypoint;
  // Returns the time of a monotonic clock, s.
  std::function<double()> time;
  // Returns the curve of the tool centre point along a path of the cell. The result is null if there is no curve, or
  // while it is being computed.
  std::function<std::shared_ptr<const GuideCurve>(const std::string& path)> guide;
  double tolerance = DistanceForceSettings().tolerance;    // mm; tolerance of the distances that are felt
  double ikTolerance = TeleoperationSettings().tolerance;  // m, rad
  std::vector<HandGuidingTrial>* trials = nullptr;         // The attempts in this document; must outlive the tool
};

// Tool that guides a robot by hand at its tool. The arm follows, but never through an obstacle or beyond a limit. The
// hand can start anywhere, and feels the robot's resistance and nearby obstacles. With the mouse, the tool moves in the
// plane of the view, or turns if Shift is pressed. A path of the cell can be followed, with a virtual fixture that
// pulls the tool to the path; the deviation is measured. Waypoints of paths are pulled in the same manner: the press
// must be near the tool centre point of a waypoint, which attracts a device. Releasing commits one edit.
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
  // Returns the joint values that the robot is led to, or those of the document if nothing is led.
  JointValues joints() const;
  // Returns the tool centre point at the values of joints(), in the frame of the base; nothing while the cell is not
  // prepared.
  std::optional<Pose> toolPose() const;

 private:
  enum class Mode { Tool, Joints, Waypoints };  // The object that follows the hand
  // A waypoint by its indices in the plans, with its tool centre point in the frame of the base.
  struct PathWaypoint {
    std::size_t path, waypoint;
    Vec3 point;
  };

  // State from press to release.
  struct Guidance;

  ToolReply press(const PointerEvent& event);
  void begin(const PointerEvent& event);
  void beginAt(const PointerEvent& event, const std::shared_ptr<const CellScene>& scene, const ArmValues& start);
  ToolReply takeWaypoint(const PointerEvent& event);
  void setWaypoint(const Guidance& pulled);
  const std::vector<PathWaypoint>& waypoints();
  std::optional<PathWaypoint> waypointNear(const PointerEvent& event);
  void takeGuide();
  void follow(const PointerEvent& event);
  void leadJoints(const Pose& hand);
  Pose wantedPose(const PointerEvent& event) const;
  ToolReply release();
  std::shared_ptr<const GuideCurve> guide() const;  // Null: no guide, or not computed yet
  std::vector<std::string> pathNames() const;
  void addFigures(std::vector<Property>& all) const;

  RobotCellDocument& m_document;
  HandGuidingServices m_services;
  std::shared_ptr<Guidance> m_guidance;  // Null: nothing is led
  std::string m_path;                    // The path to follow; empty: none
  Mode m_mode = Mode::Tool;
  double m_scale = 1.0;         // Motion of the tool per motion of the hand
  bool m_turns = true;          // True if the tool turns with the hand
  ApproachSettings m_approach;  // Also for the force of the robot itself
  double m_snapDistance = 0.0;  // mm; 0: no fixture
  double m_grasp = 15.0;        // mm: distance within which a press takes a waypoint
  // All waypoints that can be pulled, and the plans, scene and path that they were determined for.
  std::vector<PathWaypoint> m_waypoints;
  std::shared_ptr<const CellPlans> m_waypointsOf;
  std::weak_ptr<const CellScene> m_waypointsIn;
  std::string m_waypointsAlong;
  std::optional<PathWaypoint> m_near;  // The waypoint that a press would take
  std::optional<Vec3> m_tip;           // Position of the device tip, which m_near attracts
};

}  // namespace handwheel
