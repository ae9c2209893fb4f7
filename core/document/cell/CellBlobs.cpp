// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/CellBlobs.h"

#include "base/JsonText.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellImport.h"
#include "document/cell/PlansBlobs.h"
#include "document/cell/SurfaceBudget.h"
#include "document/container/ArchiveErrors.h"
#include "document/scene/BodyBlobs.h"
#include "document/scene/SurfaceBlobs.h"
#include "robot/UrdfReader.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

namespace handwheel {

namespace {

const std::string kCellFolder = "cell";
const std::string kDescription = "cell/robot.urdf";

std::string surfaceName(std::size_t shape) {
  char number[16];
  std::snprintf(number, sizeof number, "%04zu", shape);
  return std::string("cell/surfaces/") + number;
}

class Loading {
 public:
  Loading(const Container& container, std::uint32_t shapeSides, std::vector<Error>& damage)
      : m_container(container), m_shapeSides(shapeSides), m_damage(damage) {
    const auto document = container.manifest->find("document");
    if (document != container.manifest->end() && document->is_object()) m_document = *document;
  }

  Result<SnapshotPointer> read(Progress progress) {
    const auto description = m_container.blobs.find(kDescription);
    if (description == m_container.blobs.end()) return Error{ArchiveError::EntryMissing, {kDescription}, {}, {}};
    // Faults of the description were reported when it was imported; it is saved unchanged.
    Result<ImportedRobot> read = readUrdf(description->second, progress.part(0.0, 0.1));
    if (!read) return read.error();
    auto robot = std::make_shared<CellRobot>();
    robot->model = std::move(read->robot);
    robot->arms = readArms(robot->model);
    robot->description = description->second;
    SurfaceBudget budget(robot->model);
    for (std::size_t i = 0; i < robot->model.shapes.size(); ++i) {
      if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
      auto surface = surfaceOf(robot->model.shapes[i], i);
      if (surface && !budget.take(i, *surface)) {
        m_damage.push_back(SurfaceBudget::exceeded());
        surface = nullptr;
      }
      robot->surfaces.push_back(std::move(surface));
    }
    auto cell = std::make_shared<RobotCellSnapshot>();
    cell->joints = readJoints(robot->model);
    cell->plans = readPlans(m_container, robot->model, cell->joints, m_damage);
    if (!armNumber(*robot, cell->plans->arm)) {
      auto plans = std::make_shared<CellPlans>(*cell->plans);
      m_damage.push_back({ErrorCode::ReferenceMissing, {"the robot", std::exchange(plans->arm, {})}, {}, {}});
      cell->plans = std::move(plans);
    }
    cell->proofs = std::make_shared<const PathProofs>(readProofs(m_container));
    cell->robot = std::move(robot);
    Result<BodySet> bodies = readBodies(m_container, kCellFolder, m_damage, progress.part(0.5, 1.0));
    if (!bodies) return bodies.error();
    cell->bodies = std::move(bodies).value();
    const auto known = m_document.find("resting_pairs_known");
    cell->areRestingPairsKnown = known != m_document.end() && known->is_boolean() && known->get<bool>();
    const auto source = m_document.find("source");
    if (source != m_document.end() && source->is_string()) cell->source = source->get<std::string>();
    return SnapshotPointer(std::move(cell));
  }

 private:
  std::shared_ptr<const TriangleSoup> surfaceOf(const Shape& shape, std::size_t number) {
    if (!std::holds_alternative<MeshShape>(shape)) return roundedSurface(shape, m_shapeSides);
    const auto surfaces = m_document.find("surfaces");
    const std::string name = surfaceName(number);
    if (surfaces == m_document.end() || !surfaces->is_array() || number >= surfaces->size()) {
      m_damage.push_back({ArchiveError::EntryMissing, {name}, {}, {}});
      return nullptr;
    }
    const nlohmann::json& counts = (*surfaces)[number];
    if (counts.is_null()) return nullptr;  // it was missing when the cell was saved
    std::uint64_t lost = 0;
    TriangleSoup soup = readSoupBlobs<float>(counts, name, m_container, kLargestCoordinate, lost);
    if (lost > 0 || soup.triangles.empty()) m_damage.push_back({ArchiveError::EntryDamaged, {name}, {}, {}});
    if (soup.triangles.empty()) return nullptr;
    return std::make_shared<const TriangleSoup>(std::move(soup));
  }

  // One robot, unless it is said how several share the description.
  std::vector<RobotArm> readArms(const RobotModel& model) const {
    const auto stored = m_document.find("robots");
    if (stored == m_document.end()) return {wholeArm(model)};
    std::vector<RobotArm> arms;
    const bool isList = stored->is_array() && stored->size() <= model.links.size();
    for (const nlohmann::json& entry : isList ? *stored : nlohmann::json::array()) {
      const RobotArm arm{stringAt(entry, "name"), stringAt(entry, "title"), linkNamed(model, stringAt(entry, "base")),
                         linkNamed(model, stringAt(entry, "flange"))};
      const auto isSame = [&](const RobotArm& each) { return each.name == arm.name || each.base == arm.base; };
      if (isArm(model, arm) && std::none_of(arms.begin(), arms.end(), isSame)) arms.push_back(arm);
    }
    if (!arms.empty() && arms.size() == stored->size() && haveOwnFlanges(model, arms)) return arms;
    m_damage.push_back({ErrorCode::ElementMalformed, {"robots", "a robot is not in the description"}, {}, {}});
    return {wholeArm(model)};
  }

  // Its base is the root or fixed to it.
  static bool isArm(const RobotModel& model, const RobotArm& arm) {
    if (arm.name.empty() || arm.base == kNone || arm.flange == kNone) return false;
    const std::uint32_t mount = model.links[arm.base].parentJoint;
    return mount == kNone || (model.joints[mount].kind == JointKind::Fixed && model.joints[mount].parent == model.root);
  }

  // The flange of each hangs on its base, and not on that of another one between.
  static bool haveOwnFlanges(const RobotModel& model, const std::vector<RobotArm>& arms) {
    const std::vector<std::uint32_t> owners = armsOfLinks(model, arms);
    for (std::size_t i = 0; i < arms.size(); ++i) {
      if (owners[arms[i].flange] != i) return false;
    }
    return true;
  }

  JointValues readJoints(const RobotModel& model) const {
    JointValues values = restValues(model);
    const auto joints = m_document.find("joints");
    if (joints == m_document.end() || !joints->is_object()) return values;
    for (std::size_t dof = 0; dof < model.dofs.size(); ++dof) {
      const auto value = joints->find(model.jointOfDof(dof).name);
      if (value == joints->end() || !value->is_number()) continue;
      const double number = value->get<double>();
      if (std::isfinite(number)) values[static_cast<Eigen::Index>(dof)] = number;
    }
    return withinLimits(model, values);
  }

  const Container& m_container;
  std::uint32_t m_shapeSides;
  std::vector<Error>& m_damage;
  nlohmann::json m_document = nlohmann::json::object();
};

}  // namespace

void writeCell(const RobotCellSnapshot& cell, Container& container) {
  nlohmann::json& document = (*container.manifest)["document"];
  const CellRobot& robot = *cell.robot;
  container.blobs[kDescription] = robot.description;
  document["source"] = cell.source;
  if (cell.areRestingPairsKnown) document["resting_pairs_known"] = true;
  if (robot.arms != std::vector<RobotArm>{wholeArm(robot.model)}) {
    document["robots"] = nlohmann::json::array();
    for (const RobotArm& arm : robot.arms) {
      document["robots"].push_back({{"name", arm.name},
                                    {"title", arm.title},
                                    {"base", robot.model.links[arm.base].name},
                                    {"flange", robot.model.links[arm.flange].name}});
    }
  }
  document["joints"] = nlohmann::json::object();
  for (std::size_t dof = 0; dof < robot.model.dofs.size(); ++dof)
    document["joints"][robot.model.jointOfDof(dof).name] = cell.joints[static_cast<Eigen::Index>(dof)];
  document["surfaces"] = nlohmann::json::array();
  for (std::size_t i = 0; i < robot.surfaces.size(); ++i) {
    const bool isStored = robot.surfaces[i] && std::holds_alternative<MeshShape>(robot.model.shapes[i]);
    document["surfaces"].push_back(isStored ? writeSoupBlobs<float>(*robot.surfaces[i], surfaceName(i), container)
                                            : nlohmann::json());
  }
  writePlans(*cell.plans, robot.model, container);
  std::set<std::string> paths;
  for (const RobotPath& path : cell.plans->paths) paths.insert(path.name);
  writeProofs(*cell.proofs, paths, container);
  writeBodies(cell.bodies, kCellFolder, container);
}

Result<SnapshotPointer> readCell(const Container& container, std::uint32_t shapeSides, std::vector<Error>& damage,
                                 Progress progress) {
  return Loading(container, shapeSides, damage).read(progress);
}

}  // namespace handwheel
