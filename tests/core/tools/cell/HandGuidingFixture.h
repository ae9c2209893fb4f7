// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "../ToolEvents.h"
#include "document/cell/CellImport.h"
#include "document/cell/RobotCellKind.h"
#include "document/scene/BodyChanges.h"
#include "robot/dh/DhTable.h"
#include "scene/PrimitiveGeometry.h"
#include "tools/cell/HandGuidingTool.h"
#include "tools/cell/path/PathCheck.h"

namespace handwheel::test {

// A cell in which the tool of an IRB 120 is guided by hand. There is a wall at x = 420 mm.
class HandGuidingFixture {
 public:
  HandGuidingFixture() {
    auto cell = std::make_shared<RobotCellSnapshot>(*cellOf(*libraryTable("irb120")));
    cell->joints = start();
    OpenedFile opened;
    opened.kind = &m_kind;
    opened.content = cell;
    m_document = std::make_unique<RobotCellDocument>(std::move(opened));
    Body wall{.name = "wall", .geometry = *PrimitiveGeometry::make(Primitive::Cuboid, {100, 2000, 2000})};
    wall.pose.translation() = Vec3(470, 0, 600);
    document().commit("Add", std::move(addBodyEdit(document().bodies(), wall)).value());
    prepare();
  }
  void prepare() {
    auto prepared = sceneOf(static_cast<const RobotCellSnapshot&>(*document().snapshot()), m_meshes);
    m_scene = std::make_shared<const CellScene>(std::move(prepared).value());
  }
  static JointValues start() {
    JointValues values(6);
    values << 0.2, 0.1, 0.3, 0.1, 0.7, 0.0;
    return values;
  }
  RobotCellDocument& document() { return *m_document; }
  HandGuidingTool tool() {
    HandGuidingServices services;
    services.scene = [this] { return isUnderWay ? nullptr : m_scene; };
    services.addWaypoint = [this] { ++added; };
    services.time = [this] { return time; };
    services.trials = &trials;
    services.guide = [this](const std::string& name) {
      const RobotPath* const path = isUnderWay || guideComesAt > time ? nullptr : document().plans()->path(name);
      return path ? std::make_shared<const GuideCurve>(toolCurve(*m_scene, *document().plans(), *path)) : nullptr;
    };
    return {document(), std::move(services)};
  }
  Pose toolPose(const JointValues& joints) const { return m_scene->arm.tipPose(m_scene->planned(joints)); }
  Pose toolPose() { return toolPose(document().joints()); }
  double clearance() { return clearance(document().joints()); }
  double clearance(const JointValues& joints) { return m_scene->scene.nearest(m_scene->planned(joints), 1e3).distance; }
  const Waypoint& waypoint(std::size_t number) { return document().plans()->path("turn")->waypoints[number]; }
  Pose poseAt(std::size_t number) { return toolPose(waypoint(number).joints); }
  int steps() { return document().history()->index(); }
  // Adds a path on which only the first joint turns.
  void addTurn(double angle) {
    CellPlans plans = *document().plans();
    RobotPath path{"turn", {{.joints = start()}, {.joints = start()}}};
    path.waypoints.back().joints[0] += angle;
    plans.paths.push_back(path);
    document().commit("Add a path", document().plansEdit(plans));
  }

  int added = 0;
  bool isUnderWay = false;  // true if the cell is being prepared
  double time = 0.0, guideComesAt = 0.0;
  std::vector<HandGuidingTrial> trials;

 private:
  RobotCellKind m_kind;
  std::unique_ptr<RobotCellDocument> m_document;
  CollisionMeshes m_meshes;
  std::shared_ptr<const CellScene> m_scene;
};

inline PointerEvent byHand(Kind kind, const Pose& hand) {
  PointerEvent event = above(kind, hand.translation().x(), hand.translation().y());
  event.device = hand;
  return event;
}

inline Pose moved(const Vec3& by) {
  return Pose(Eigen::Translation3d(by));
}

}  // namespace handwheel::test
