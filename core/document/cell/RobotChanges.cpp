// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/RobotChanges.h"

#include "base/NumberText.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellErrors.h"
#include "document/cell/CellFrames.h"
#include "document/cell/PlansEdit.h"
#include "document/cell/SurfaceBudget.h"
#include "document/scene/BodyChanges.h"
#include "robot/Kinematics.h"
#include "robot/UrdfReader.h"
#include "robot/UrdfWriter.h"
#include "scene/RigidPose.h"

#include <algorithm>
#include <map>

namespace handwheel {

namespace {

using Surfaces = std::vector<std::shared_ptr<const TriangleSoup>>;

// The surfaces by the numbers that the shapes have once they were written and read; the links are in the same order.
Surfaces surfacesOf(const RobotModel& written, const Surfaces& surfaces, const RobotModel& read) {
  Surfaces found(read.shapes.size());
  for (std::size_t l = 0; l < read.links.size(); ++l) {
    for (const auto shapes : {&Link::visuals, &Link::collisions}) {
      const auto &before = written.links[l].*shapes, &after = read.links[l].*shapes;
      for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i)
        found[after[i].shape] = surfaces[before[i].shape];
    }
  }
  return found;
}

// A model as a cell keeps it: what is read again from what is written of it, so that it is the same when it is loaded.
// arms, surfaces: of the model.
Result<std::shared_ptr<const CellRobot>> kept(const RobotModel& model, std::vector<RobotArm> arms,
                                              const Surfaces& surfaces) {
  auto robot = std::make_shared<CellRobot>();
  robot->description = urdfOf(model);
  Result<ImportedRobot> read = readUrdf(robot->description);
  if (!read) return read.error();
  robot->model = std::move(read->robot);
  robot->surfaces = surfacesOf(model, surfaces, robot->model);
  SurfaceBudget budget(robot->model);
  for (std::size_t i = 0; i < robot->surfaces.size(); ++i) {
    if (robot->surfaces[i] && !budget.take(i, *robot->surfaces[i])) return SurfaceBudget::exceeded();
  }
  for (RobotArm& arm : arms) {
    arm.base = linkNamed(robot->model, model.links[arm.base].name);
    arm.flange = linkNamed(robot->model, model.links[arm.flange].name);
  }
  robot->arms = std::move(arms);
  return std::shared_ptr<const CellRobot>(std::move(robot));
}

// Joint values of one model as those of another, by the names of the joints; those that it did not have rest.
class JointMapping {
 public:
  JointMapping(const RobotModel& from, const RobotModel& to) : m_rest(restValues(to)) {
    std::map<std::string_view, Eigen::Index> numbers;
    for (std::size_t dof = 0; dof < from.dofs.size(); ++dof)
      numbers[from.jointOfDof(dof).name] = static_cast<Eigen::Index>(dof);
    for (std::size_t dof = 0; dof < to.dofs.size(); ++dof) {
      const auto found = numbers.find(to.jointOfDof(dof).name);
      m_sources.push_back(found == numbers.end() ? -1 : found->second);
    }
  }

  JointValues of(const JointValues& values) const {
    JointValues mapped = m_rest;
    for (std::size_t dof = 0; dof < m_sources.size(); ++dof) {
      if (m_sources[dof] >= 0) mapped[static_cast<Eigen::Index>(dof)] = values[m_sources[dof]];
    }
    return mapped;
  }

  void apply(CellPlans& plans) const {
    for (NamedConfiguration& each : plans.configurations) each.joints = of(each.joints);
    for (RobotPath& path : plans.paths) {
      for (Waypoint& waypoint : path.waypoints) waypoint.joints = of(waypoint.joints);
    }
  }

 private:
  JointValues m_rest;
  std::vector<Eigen::Index> m_sources;  // Source of each degree of freedom of the new model; -1: none
};

std::optional<Error> problemOfBase(const Pose& base) {
  if (isRigid(base)) return std::nullopt;
  const std::string most = shownText(kFarthestBody);
  return Error{ErrorCode::ValueOutOfRange,
               {"the position of the robot", shownText(base.translation().cwiseAbs().maxCoeff()), "-" + most, most},
               {},
               {}};
}

// The plans without what is of a robot, and about links that are gone. Frames that these carried stand where they were.
CellPlans plansWithout(const RobotCellSnapshot& cell, std::size_t arm, const CellRobot& rest) {
  CellPlans plans = *cell.plans;
  const std::string& name = cell.robot->arms[arm].name;
  const auto isOfIt = [&](const auto& each) { return isSameArm(*cell.robot, each.arm, name); };
  std::erase_if(plans.configurations, isOfIt);
  std::erase_if(plans.paths, isOfIt);
  const bool isPlanned = activeArmNumber(*cell.robot, plans) == arm;
  if (isPlanned) plans.choose(rest.arms.front().name, name);
  plans.otherTools.erase(name);
  for (RobotPath& path : plans.paths) path.bases.erase(name);
  for (NamedFrame& frame : plans.frames) {
    const bool isReleased = !frame.link.empty() && linkNamed(rest.model, frame.link) == kNone;
    const Result<Pose> pose = poseOfFrame(frame, {*cell.plans, cell.bodies, cell.robot->model, cell.joints});
    if (isReleased && pose) frame = {frame.name, *pose};
  }
  const auto isGone = [&](const std::string& part) {
    return linkNamed(cell.robot->model, part) != kNone && linkNamed(rest.model, part) == kNone;
  };
  std::erase_if(plans.allowed, [&](const auto& pair) { return isGone(pair.first) || isGone(pair.second); });
  std::erase_if(plans.missingAs, [&](const auto& missing) { return isGone(missing.first); });
  return plans;
}

// The plans in which paths tell where this robot stands, or stood when it was first moved: those of other robots, and
// its own along curves, which do not move with it.
std::shared_ptr<const CellPlans> withBaseKept(const RobotCellSnapshot& cell, std::size_t arm) {
  const RobotArm& moved = cell.robot->arms[arm];
  const auto isToTell = [&](const RobotPath& path) {
    if (isSameArm(*cell.robot, path.arm, moved.name)) return path.process && !path.process->base;
    return !path.bases.contains(moved.name);
  };
  if (std::none_of(cell.plans->paths.begin(), cell.plans->paths.end(), isToTell)) return cell.plans;
  auto plans = std::make_shared<CellPlans>(*cell.plans);
  const Pose base = basePose(cell.robot->model, moved);
  for (RobotPath& path : plans->paths) {
    if (!isToTell(path)) continue;
    if (isSameArm(*cell.robot, path.arm, moved.name))
      path.process->base = base;
    else
      path.bases.emplace(moved.name, base);
  }
  return plans;
}

BodySet released(const RobotCellSnapshot& cell, const CellRobot& rest) {
  BodySet bodies = cell.bodies;
  const RobotModel& robot = cell.robot->model;
  const std::vector<Pose> poses = linkPoses(robot, cell.joints);
  for (const BodyPointer& body : cell.bodies) {
    if (carrierOf(*body, robot) == kNone || carrierOf(*body, rest.model) != kNone) continue;
    auto standing = std::make_shared<Body>(*body);
    standing->pose = carrierPose(*body, robot, poses) * body->pose;
    standing->carrier.clear();
    bodies = bodies.with(std::move(standing));
  }
  return bodies;
}

}  // namespace

Result<RobotCellSnapshot> withRobotAdded(const RobotCellSnapshot& cell, const AddedRobot& added) {
  const CellRobot& present = *cell.robot;
  const CellRobot& other = *added.from->robot;
  if (other.arms.size() != 1) return Error{ErrorCode::Unsupported, {"a cell with several robots as one robot"}, {}, {}};
  if (!added.name.empty() && !isBodyName(added.name)) return Error{CellError::ArmNameUnusable, {added.name}, {}, {}};
  if (const auto problem = problemOfBase(added.base)) return *problem;
  const RobotModel first = withBothShapes(present.model), second = withBothShapes(other.model);
  RobotArm arm = other.arms.front();
  arm.name = freeArmName(first, present.arms, added.name.empty() ? arm.name : added.name);
  const RobotModel all = joined(first, second, arm.name, added.base);
  arm.base += static_cast<std::uint32_t>(first.links.size());
  arm.flange += static_cast<std::uint32_t>(first.links.size());
  Surfaces surfaces = present.surfaces;
  surfaces.insert(surfaces.end(), other.surfaces.begin(), other.surfaces.end());
  std::vector<RobotArm> arms = present.arms;
  arms.push_back(arm);
  auto robot = kept(all, std::move(arms), surfaces);
  if (!robot) return robot.error();
  RobotCellSnapshot changed = cell;
  const JointMapping joints(present.model, robot.value()->model);
  changed.joints = joints.of(cell.joints);
  CellPlans plans = *cell.plans;
  joints.apply(plans);
  for (const auto& [a, b] : added.from->plans->allowed) plans.allowed.insert({arm.name + '_' + a, arm.name + '_' + b});
  if (const Status fits = checkCounts(plans); !fits) return fits.error();
  changed.plans = std::make_shared<const CellPlans>(std::move(plans));
  changed.robot = std::move(robot).value();
  return changed;
}

Result<RobotCellSnapshot> withRobotRemoved(const RobotCellSnapshot& cell, std::size_t arm) {
  const CellRobot& present = *cell.robot;
  if (present.arms.size() < 2) return Error{CellError::OnlyRobot, {present.arms[arm].name}, {}, {}};
  const RobotModel rest = withoutArm(present.model, present.arms, arm);
  std::vector<RobotArm> arms;
  for (std::size_t i = 0; i < present.arms.size(); ++i) {
    if (i == arm) continue;
    RobotArm other = present.arms[i];
    other.base = linkNamed(rest, present.model.links[other.base].name);
    other.flange = linkNamed(rest, present.model.links[other.flange].name);
    arms.push_back(other);
  }
  Surfaces surfaces(rest.shapes.size());
  for (const Link& link : rest.links) {
    const std::uint32_t before = linkNamed(present.model, link.name);
    if (before == kNone) continue;  // the bare root
    for (const auto shapes : {&Link::visuals, &Link::collisions}) {
      for (std::size_t i = 0; i < (link.*shapes).size(); ++i)
        surfaces[(link.*shapes)[i].shape] = present.surfaces[(present.model.links[before].*shapes)[i].shape];
    }
  }
  auto robot = kept(rest, std::move(arms), surfaces);
  if (!robot) return robot.error();
  RobotCellSnapshot changed = cell;
  const JointMapping joints(present.model, robot.value()->model);
  changed.joints = joints.of(cell.joints);
  CellPlans plans = plansWithout(cell, arm, *robot.value());
  joints.apply(plans);
  changed.plans = std::make_shared<const CellPlans>(std::move(plans));
  changed.bodies = released(cell, *robot.value());
  changed.robot = std::move(robot).value();
  return changed;
}

Result<RobotCellSnapshot> withRobotMoved(const RobotCellSnapshot& cell, std::size_t arm, const Pose& base) {
  const CellRobot& present = *cell.robot;
  if (present.arms[arm].base == present.model.root)
    return Error{CellError::ArmOnRoot, {present.arms[arm].name}, {}, {}};
  if (const auto problem = problemOfBase(base)) return *problem;
  auto robot = kept(withBaseAt(present.model, present.arms[arm], base), present.arms, present.surfaces);
  if (!robot) return robot.error();
  RobotCellSnapshot changed = cell;
  changed.plans = withBaseKept(cell, arm);
  changed.robot = std::move(robot).value();
  return changed;
}

}  // namespace handwheel
