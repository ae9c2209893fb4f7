// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Pulling waypoints (He 2008, chapter 6: key configurations).
#include "document/cell/CellArms.h"
#include "tools/cell/HandGuidingState.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

constexpr double kGraspPixels = 8.0;  // Logical pixels: a waypoint can be pointed to at any zoom

}  // namespace

// Returns those of the chosen path, or else of all paths of the robot that is planned for. O(waypoints) after a change.
const std::vector<HandGuidingTool::PathWaypoint>& HandGuidingTool::waypoints() {
  const auto scene = m_services.scene();
  const auto plans = m_document.plans();
  if (m_waypointsOf == plans && m_waypointsIn.lock() == scene && m_waypointsAlong == m_path) return m_waypoints;
  m_waypoints.clear();
  m_waypointsOf = plans;
  m_waypointsIn = scene;
  m_waypointsAlong = m_path;
  if (!scene) return m_waypoints;
  for (std::size_t p = 0; p < plans->paths.size(); ++p) {
    const RobotPath& path = plans->paths[p];
    if (!isSameArm(m_document.robot(), path.arm, plans->arm) || !(m_path.empty() || path.name == m_path)) continue;
    for (std::size_t i = 0; i < path.waypoints.size(); ++i) {
      const Pose there = scene->arm.tipPose(scene->planned(path.waypoints[i].joints)) * plans->tool;
      m_waypoints.push_back({p, i, there.translation()});
    }
  }
  return m_waypoints;
}

// Nearest to the tip of a device, or to the ray of the mouse; none within the distance in which one is taken.
std::optional<HandGuidingTool::PathWaypoint> HandGuidingTool::waypointNear(const PointerEvent& event) {
  if (m_mode != Mode::Waypoints || !(event.device || event.ray.isUsable())) return std::nullopt;
  std::optional<PathWaypoint> nearest;
  double least = 1.0;  // Shares of that distance
  for (const PathWaypoint& each : waypoints()) {
    double distance = 0.0, within = m_grasp;
    if (event.device) {
      distance = (each.point - event.device->translation()).norm();
    } else {
      const Vec3 away = each.point - event.ray.origin;
      if (away.dot(event.ray.direction) < 0.0) continue;  // behind the eye
      distance = away.cross(event.ray.direction).norm();
      const double pixel = event.pickRay().pixelAt(each.point);
      if (pixel > 0.0) within = std::max(within, kGraspPixels * pixel);
    }
    if (!(distance <= least * within)) continue;
    least = distance / within;
    nearest = each;
  }
  return nearest;
}

// Shows the robot at the waypoint and leads it from there; in the document it does not move.
ToolReply HandGuidingTool::takeWaypoint(const PointerEvent& event) {
  const auto taken = waypointNear(event);
  const auto scene = m_services.scene();
  if (!taken || !scene) return ToolReply::Ignored;
  const RobotPath& path = m_document.plans()->paths[taken->path];
  beginAt(event, scene, scene->planned(path.waypoints[taken->waypoint].joints));
  m_guidance->pulled = taken;
  m_near.reset();
  return ToolReply::Used;
}

// Changes the waypoint like an edit by the user: the path is no longer planned along a curve, and planning it again
// passes the waypoint.
void HandGuidingTool::setWaypoint(const Guidance& pulled) {
  CellPlans plans = *m_document.plans();
  RobotPath& path = plans.paths[pulled.pulled->path];
  Waypoint& waypoint = path.waypoints[pulled.pulled->waypoint];
  const ArmValues& values = pulled.robot.values();
  for (std::size_t i = 0; i < pulled.scene->dofs.size(); ++i)
    waypoint.joints[pulled.scene->dofs[i]] = values[static_cast<Eigen::Index>(i)];
  waypoint.isCritical = true;
  waypoint.target.reset();
  waypoint.frame.reset();
  waypoint.configuration.clear();
  path.process.reset();
  const QString text = QCoreApplication::translate("HandGuidingTool", "Pull place %1 of %2")
                           .arg(pulled.pulled->waypoint + 1)
                           .arg(QString::fromStdString(path.name));
  if (auto edit = m_document.plansEdit(std::move(plans))) m_document.commit(text, std::move(edit));
}

}  // namespace handwheel
