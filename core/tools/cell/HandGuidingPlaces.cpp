// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// How places of paths are pulled (He 2008, chapter 6: key configurations).
#include "document/cell/CellArms.h"
#include "tools/cell/HandGuidingState.h"

#include <QCoreApplication>
#include <algorithm>

namespace handwheel {

namespace {

constexpr double kGraspPixels = 8.0;  // logical: however far one looks from, a place can be pointed to

}  // namespace

// Of the path that is chosen, or else of all paths of the robot that is planned for. O(places) after a change.
const std::vector<HandGuidingTool::PathPlace>& HandGuidingTool::places() {
  const auto scene = m_services.scene();
  const auto plans = m_document.plans();
  if (m_placesOf == plans && m_placesIn.lock() == scene && m_placesAlong == m_path) return m_places;
  m_places.clear();
  m_placesOf = plans;
  m_placesIn = scene;
  m_placesAlong = m_path;
  if (!scene) return m_places;
  for (std::size_t p = 0; p < plans->paths.size(); ++p) {
    const RobotPath& path = plans->paths[p];
    if (!isSameArm(m_document.robot(), path.arm, plans->arm) || !(m_path.empty() || path.name == m_path)) continue;
    for (std::size_t i = 0; i < path.places.size(); ++i) {
      const Pose there = scene->arm.tipPose(scene->planned(path.places[i].joints)) * plans->tool;
      m_places.push_back({p, i, there.translation()});
    }
  }
  return m_places;
}

// Nearest to the tip of a device, or to the ray of the mouse; none within the distance in which one is taken.
std::optional<HandGuidingTool::PathPlace> HandGuidingTool::placeNear(const PointerEvent& event) {
  if (m_way != Way::Places || !(event.device || event.ray.isUsable())) return std::nullopt;
  std::optional<PathPlace> nearest;
  double least = 1.0;  // of the shares of that distance
  for (const PathPlace& each : places()) {
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

// The robot is shown at the place and led from there; in the document it stays where it stands.
ToolReply HandGuidingTool::takePlace(const PointerEvent& event) {
  const auto taken = placeNear(event);
  const auto scene = m_services.scene();
  if (!taken || !scene) return ToolReply::Ignored;
  const RobotPath& path = m_document.plans()->paths[taken->path];
  beginAt(event, scene, scene->planned(path.places[taken->place].joints));
  m_guidance->pulled = taken;
  m_near.reset();
  return ToolReply::Used;
}

// As a person sets a place anew: the path is no longer planned along a curve, and planning it again passes the place.
void HandGuidingTool::setPlace(const Guidance& pulled) {
  CellPlans plans = *m_document.plans();
  RobotPath& path = plans.paths[pulled.pulled->path];
  Waypoint& place = path.places[pulled.pulled->place];
  const ArmValues& values = pulled.robot.values();
  for (std::size_t i = 0; i < pulled.scene->dofs.size(); ++i)
    place.joints[pulled.scene->dofs[i]] = values[static_cast<Eigen::Index>(i)];
  place.isCritical = true;
  place.target.reset();
  place.configuration.clear();
  path.process.reset();
  const QString text = QCoreApplication::translate("HandGuidingTool", "Pull place %1 of %2")
                           .arg(pulled.pulled->place + 1)
                           .arg(QString::fromStdString(path.name));
  if (auto edit = m_document.plansEdit(std::move(plans))) m_document.commit(text, std::move(edit));
}

}  // namespace handwheel
