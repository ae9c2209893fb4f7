// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/RobotCellKind.h"

#include "document/AtomicFile.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellBlobs.h"
#include "document/cell/CellDisplay.h"
#include "document/cell/CellImport.h"
#include "document/cell/RobotCellDocument.h"
#include "document/cell/path/OutdatedReasons.h"
#include "document/cell/path/PathDigests.h"
#include "document/cell/proof/MissingShapes.h"
#include "document/cell/proof/RestingPairs.h"
#include "document/formats/MeshExport.h"
#include "document/scene/BodyDescription.h"
#include "document/scene/BodyDisplay.h"
#include "document/scene/BodyLinks.h"
#include "mesh/structure/MeshErrors.h"
#include "robot/Kinematics.h"
#include "robot/UrdfReader.h"
#include "robot/dh/DhTable.h"
#include "robot/program/PathFile.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

const RobotCellSnapshot& cellOf(const Snapshot& content) {
  return static_cast<const RobotCellSnapshot&>(content);
}

const char* nameOf(JointKind kind) {
  switch (kind) {
    case JointKind::Revolute:
      return "revolute";
    case JointKind::Continuous:
      return "continuous";
    case JointKind::Prismatic:
      return "prismatic";
    case JointKind::Fixed:
      break;
  }
  return "fixed";
}

// Null for what is not known and for what has no limit.
nlohmann::json numberOrNull(std::optional<double> value) {
  return value && std::isfinite(*value) ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json describeJoints(const RobotModel& robot, const JointValues& values) {
  nlohmann::json joints = nlohmann::json::array();
  for (std::size_t dof = 0; dof < robot.dofs.size(); ++dof) {
    const Joint& joint = robot.jointOfDof(dof);
    joints.push_back({{"name", joint.name},
                      {"kind", nameOf(joint.kind)},
                      {"value", values[static_cast<Eigen::Index>(dof)]},
                      {"lower", numberOrNull(joint.limits.lower)},
                      {"upper", numberOrNull(joint.limits.upper)},
                      {"velocity", numberOrNull(joint.limits.velocity)},
                      {"effort", numberOrNull(joint.limits.effort)}});
  }
  return joints;
}

nlohmann::json withPose(nlohmann::json described, const Pose& pose) {
  const Vec3 at = pose.translation();
  const Eigen::Quaterniond turn(pose.linear());
  described["position"] = {at.x(), at.y(), at.z()};
  described["quaternion"] = {turn.w(), turn.x(), turn.y(), turn.z()};
  return described;
}

// Returns the name of the robot whose joints something sets.
std::string describedArm(const RobotCellSnapshot& cell, const std::string& arm) {
  const auto number = armNumber(*cell.robot, arm);
  return number ? cell.robot->arms[*number].name : arm;
}

// Describes the flange of the planned robot, in the frame of the cell.
nlohmann::json describeFlange(const RobotCellSnapshot& cell) {
  const RobotModel& robot = cell.robot->model;
  const std::uint32_t link = activeArm(*cell.robot, *cell.plans).flange;
  const Pose pose = linkPoses(robot, cell.joints)[link];
  return withPose({{"link", robot.links[link].name}}, pose);
}

// Describes the tool centre point of the planned robot, in the frame of the cell and in that of the flange.
nlohmann::json describeCentrePoint(const RobotCellSnapshot& cell) {
  const Pose flange = linkPoses(cell.robot->model, cell.joints)[activeArm(*cell.robot, *cell.plans).flange];
  return withPose({{"on_flange", withPose(nlohmann::json::object(), cell.plans->tool)}}, flange * cell.plans->tool);
}

nlohmann::json describeConfigurations(const RobotCellSnapshot& cell) {
  nlohmann::json list = nlohmann::json::array();
  for (const NamedConfiguration& each : cell.plans->configurations)
    list.push_back({{"name", each.name},
                    {"robot", describedArm(cell, each.arm)},
                    {"joints", toJson(cell.robot->model, each.joints)}});
  return list;
}

nlohmann::json describeTargets(const RobotCellSnapshot& cell) {
  nlohmann::json list = nlohmann::json::array();
  for (const NamedTarget& each : cell.plans->targets) {
    const BodyPointer body = cell.bodies.withId(each.body);
    list.push_back(withPose({{"name", each.name},
                             {"body", body ? nlohmann::json(body->name) : nlohmann::json()},
                             {"frame", each.frame.empty() ? nlohmann::json() : nlohmann::json(each.frame)}},
                            each.pose));
  }
  return list;
}

// In what carries them.
nlohmann::json describeFrames(const RobotCellSnapshot& cell) {
  nlohmann::json list = nlohmann::json::array();
  for (const NamedFrame& each : cell.plans->frames) {
    const BodyPointer body = cell.bodies.withId(each.body);
    list.push_back(withPose({{"name", each.name},
                             {"body", body ? nlohmann::json(body->name) : nlohmann::json()},
                             {"link", each.link.empty() ? nlohmann::json() : nlohmann::json(each.link)},
                             {"chosen", each.name == cell.plans->workFrame}},
                            each.pose));
  }
  return list;
}

// Describes the findings for the cell at that time.
nlohmann::json describeProof(const PathProof& proof, const BasisDigests& now) {
  const PathFindings& found = proof.found;
  const std::size_t tooNear = std::min(found.tooNear, found.collisions);
  nlohmann::json described = {{"at", proof.at},
                              {"certified", found.isCertified},
                              {"clearance_mm", found.leastClearance},
                              {"collisions", found.collisions - tooNear},
                              {"too_near", tooNear},
                              {"not_checked", found.notChecked},
                              {"touching", found.isTouching},
                              {"missing_shapes", describeMissing(found.missing)},
                              {"changed_since", nullptr}};
  if (const char* const change = keyOf(changeBetween(proof.basis, now))) described["changed_since"] = change;
  if (found.stopsAt) described["stops_at"] = *found.stopsAt;
  if (!found.gaps.empty()) {
    const ProofGap& gap = found.gaps.front();
    const bool isCorner = gap.kind == ProofGap::Kind::Corner;
    described["not_proven"] = {{"place", gap.waypoint}, {"reason", isCorner ? "cnt" : "carried"}};
    if (!isCorner) described["not_proven"]["text"] = gap.text;
  }
  return described;
}

nlohmann::json describePaths(const RobotCellSnapshot& cell) {
  nlohmann::json list = nlohmann::json::array();
  const CellPlacement placement{*cell.plans, cell.bodies, cell.robot->model, cell.joints};
  std::optional<PathDigests> digests;  // they read all shapes: only where something is known of a path
  for (const RobotPath& path : cell.plans->paths) {
    const OutdatedReasons outdated = outdatedReasonsOf(*cell.robot, placement, path);
    list.push_back({{"name", path.name},
                    {"robot", describedArm(cell, path.arm)},
                    {"places", path.waypoints.size()},
                    {"outdated", outdated.isAny()}});
    if (!outdated.part.empty()) list.back()["part_moved"] = outdated.part;
    if (outdated.isBaseOther) list.back()["base_moved"] = true;
    if (outdated.isToolOther) list.back()["tool_changed"] = true;
    if (!outdated.targets.empty()) list.back()["targets_moved"] = outdated.targets;
    if (!outdated.frames.empty()) list.back()["frames_moved"] = outdated.frames;
    if (!outdated.configurations.empty()) list.back()["configurations_changed"] = outdated.configurations;
    const auto proof = cell.proofs->find(path.name);
    if (proof == cell.proofs->end()) continue;
    if (!digests) digests.emplace(std::make_shared<const RobotCellSnapshot>(cell));
    list.back()["verified"] = describeProof(proof->second, digests->of(path));
  }
  return list;
}

// Bodies by their names; those that were removed by their numbers.
nlohmann::json describeAllowed(const RobotCellSnapshot& cell) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [one, other] : cell.plans->allowed)
    list.push_back(nlohmann::json::array({shownPart(one, cell.bodies), shownPart(other, cell.bodies)}));
  return list;
}

// Bodies that are not shown are not exported.
std::optional<Note> noteOnHidden(const BodySet& bodies) {
  constexpr std::size_t kMostNamed = 5;
  std::size_t count = 0;
  std::string names;
  for (const BodyPointer& body : bodies) {
    if (body->visible || ++count > kMostNamed) continue;
    names += (count > 1 ? ", " : "") + body->name;
  }
  if (count == 0) return std::nullopt;
  if (count == 1) return Note{QT_TRANSLATE_NOOP("Note", "1 hidden body (%1) was left out."), {names}, true};
  if (count > kMostNamed) names += ", …";
  return Note{QT_TRANSLATE_NOOP("Note", "%1 hidden bodies (%2) were left out."), {std::to_string(count), names}, true};
}

}  // namespace

nlohmann::json describeRobots(const RobotCellSnapshot& cell) {
  const RobotModel& robot = cell.robot->model;
  nlohmann::json list = nlohmann::json::array();
  for (const RobotArm& arm : cell.robot->arms) {
    list.push_back(withPose({{"name", arm.name},
                             {"title", arm.title},
                             {"base", robot.links[arm.base].name},
                             {"flange", robot.links[arm.flange].name},
                             {"planned", arm == activeArm(*cell.robot, *cell.plans)}},
                            basePose(robot, arm)));
  }
  return list;
}

std::string RobotCellKind::title() const {
  return QT_TRANSLATE_NOOP("DocumentKind", "Robot cell");
}

std::vector<FileFormat> RobotCellKind::formats() const {
  std::vector<FileFormat> all{{"URDF", {".urdf"}, true, false}, {"Denavit-Hartenberg", {".dh.json"}, true, false}};
  for (const FileFormat& format : meshFileFormats()) {
    if (format.writes) all.push_back({format.name, format.endings, false, true});
  }
  return all;
}

bool RobotCellKind::recognises(std::string_view head, std::string_view name) const {
  return looksLikeUrdf(head) || looksLikeDhTable(head) || name.ends_with(".urdf") || name.ends_with(".URDF");
}

Result<OpenedFile> RobotCellKind::import(const std::filesystem::path& path, const ReadOptions&,
                                         Progress progress) const {
  Result<ImportedCell> imported = importCell(path, m_shapeSides, progress);
  if (!imported) return imported.error();
  OpenedFile opened;
  opened.kind = this;
  opened.file.damage = std::move(imported->damage);
  opened.file.unlistedDamage = imported->unlistedDamage;
  opened.file.notes = std::move(imported->notes);
  opened.content = std::move(imported->cell);
  return opened;
}

Result<WrittenFile> RobotCellKind::exportTo(const Snapshot& content, const std::filesystem::path& path,
                                            Progress progress) const {
  const Result<MeshFormat> format = formatForOutput(path);
  if (!format) return format.error();
  const TriangleSoup soup = placedSoup(display(content));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (soup.triangles.empty()) return Error{MeshError::NoTriangles, {}, {}, {}};
  const Result<std::string> bytes =
      encodeChecked(soup, *format, numberTypeOf(*format, NumberType::Float64), progress.part(0.2, 0.8));
  if (!bytes) return bytes.error();
  const Status written = writeFileAtomically(path, *bytes, progress.part(0.8, 1.0));
  if (!written) return written.error();
  std::vector<Note> notes{{QT_TRANSLATE_NOOP(
      "Note", "The file contains the robot and the bodies in their current position; it has no joints.")}};
  if (auto hidden = noteOnHidden(cellOf(content).bodies)) notes.push_back(std::move(*hidden));
  return WrittenFile{bytes->size(), std::move(notes), true};
}

void RobotCellKind::save(const Snapshot& content, Container& container) const {
  writeCell(cellOf(content), container);
}

Result<SnapshotPointer> RobotCellKind::load(const Container& container, std::vector<Error>& damage,
                                            Progress progress) const {
  return readCell(container, m_shapeSides, damage, progress);
}

SnapshotPointer RobotCellKind::withCheckedLinks(SnapshotPointer content, const std::filesystem::path& folder,
                                                std::vector<Note>& notes, Progress progress) const {
  auto checked = std::make_shared<RobotCellSnapshot>(cellOf(*content));
  checked->bodies = withCheckedBodyLinks(checked->bodies, folder, notes, progress);
  if (checked->areRestingPairsKnown) return checked;
  checked->areRestingPairsKnown = true;
  return withRestingPairs(std::move(checked), notes);
}

std::vector<std::filesystem::path> RobotCellKind::linkedFiles(const Snapshot& content) const {
  std::vector<std::filesystem::path> files;
  for (const BodyPointer& body : cellOf(content).bodies) {
    if (body->link) files.emplace_back(body->link->path);
  }
  return files;
}

std::unique_ptr<Document> RobotCellKind::make(OpenedFile opened) const {
  return std::make_unique<RobotCellDocument>(std::move(opened));
}

nlohmann::json RobotCellKind::describe(const Snapshot& content) const {
  const RobotCellSnapshot& cell = cellOf(content);
  const RobotModel& robot = cell.robot->model;
  std::size_t triangles = 0;
  for (const DisplayPart& part : display(content).parts) triangles += part.soup->triangles.size();
  nlohmann::json missing = nlohmann::json::array();
  for (std::size_t i = 0; i < robot.shapes.size(); ++i) {
    const auto* mesh = std::get_if<MeshShape>(&robot.shapes[i]);
    if (mesh && !cell.robot->surfaces[i]) missing.push_back(mesh->file);
  }
  return {{"robot", robot.name},
          {"source", cell.source},
          {"links", robot.links.size()},
          {"fixed_joints", robot.joints.size() - robot.dofs.size()},
          {"joints", describeJoints(robot, cell.joints)},
          {"robots", describeRobots(cell)},
          {"flange", describeFlange(cell)},
          {"tcp", describeCentrePoint(cell)},
          {"tool", describeFlange(cell)},  // the name of the flange in reports of former versions
          {"triangles", triangles},
          {"missing_meshes", missing},
          {"missing_shapes", describeMissing(missingShapes(*cell.robot, cell.bodies, *cell.plans))},
          {"bodies", describeBodies(cell.bodies)},
          {"configurations", describeConfigurations(cell)},
          {"frames", describeFrames(cell)},
          {"targets", describeTargets(cell)},
          {"paths", describePaths(cell)},
          {"may_touch", describeAllowed(cell)}};
}

GeometryPointer RobotCellKind::bodyGeometry(const Snapshot& content, std::vector<Note>& notes) const {
  notes.push_back({QT_TRANSLATE_NOOP(
      "Note", "The robot is added in its current position, as one mesh: it has no joints and no colours of its own.")});
  return DocumentKind::bodyGeometry(content, notes);
}

DisplayModel RobotCellKind::display(const Snapshot& content) const {
  const RobotCellSnapshot& cell = cellOf(content);
  return displayOf(*cell.robot, cell.joints, cell.bodies);
}

}  // namespace handwheel
