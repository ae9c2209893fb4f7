// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/RobotCellDocument.h"

#include "base/NumberText.h"
#include "document/cell/BodyCarriers.h"
#include "document/cell/CellProperties.h"
#include "document/cell/CellReach.h"
#include "document/cell/JointEdit.h"
#include "document/cell/PlansEdit.h"
#include "document/cell/RobotChanges.h"
#include "document/cell/RobotsEdit.h"
#include "document/cell/WaypointProperties.h"
#include "document/cell/path/RateProperties.h"
#include "document/cell/proof/MissingShapes.h"
#include "document/scene/BodyProperties.h"
#include "scene/RigidPose.h"

#include <algorithm>
#include <charconv>

namespace handwheel {

namespace {

// "body.3.x" and "body.Table.x": what stands between the dots, and after the last one.
struct BodyField {
  std::string body;
  std::string field;
};

std::optional<BodyField> bodyFieldOf(const std::string& id) {
  const std::size_t first = id.find('.'), last = id.rfind('.');
  if (!id.starts_with("body.") || last == first) return std::nullopt;
  return BodyField{id.substr(first + 1, last - first - 1), id.substr(last + 1)};
}

// In ids of properties the number comes first: they must not change with the names.
BodyPointer bodyNamed(const BodySet& bodies, const std::string& text) {
  BodyId number = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool isNumber = error == std::errc() && stop == text.data() + text.size();
  return isNumber ? bodies.withId(number) : bodies.withName(text);
}

}  // namespace

RobotCellDocument::RobotCellDocument(OpenedFile opened, QObject* parent)
    : Document(*opened.kind, std::move(opened.file), parent),
      BodyOwner(static_cast<const RobotCellSnapshot&>(*opened.content).bodies) {
  const auto& content = static_cast<const RobotCellSnapshot&>(*opened.content);
  m_robot = content.robot;
  m_joints = content.joints;
  m_plans = content.plans;
  m_proofs = content.proofs;
  m_source = content.source;
}

SnapshotPointer RobotCellDocument::snapshot() const {
  auto snapshot = std::make_shared<RobotCellSnapshot>();
  snapshot->robot = m_robot;
  snapshot->joints = m_joints;
  snapshot->plans = m_plans;
  snapshot->proofs = m_proofs;
  snapshot->source = m_source;
  snapshot->bodies = bodies();
  return snapshot;
}

void RobotCellDocument::setProofs(PathProofs proofs, bool isChange) {
  m_proofs = std::make_shared<const PathProofs>(std::move(proofs));
  if (isChange) wasRecorded();
}

std::vector<Property> RobotCellDocument::properties() const {
  std::vector<Property> all = cellProperties(*m_robot, m_joints, *m_plans);
  for (Property& missing : missingProperties(*m_robot, bodies(), *m_plans)) all.push_back(std::move(missing));
  for (const BodyPointer& body : bodies()) {
    for (Property& ofBody : propertiesOfBody(*body)) all.push_back(std::move(ofBody));
  }
  for (const NamedFrame& frame : m_plans->frames) {
    for (Property& ofFrame : frameProperties(frame, placement())) all.push_back(std::move(ofFrame));
  }
  for (const NamedTarget& target : m_plans->targets) {
    for (Property& ofTarget : targetProperties(target, placement())) all.push_back(std::move(ofTarget));
  }
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

std::vector<Property> RobotCellDocument::propertiesWith(std::span<const Body> shown) const {
  std::vector<Property> all = cellProperties(*m_robot, m_joints, *m_plans);
  for (Property& missing : missingProperties(*m_robot, bodies(), *m_plans)) all.push_back(std::move(missing));
  for (const Body& body : shown) {
    for (Property& ofBody : propertiesOfBody(body)) all.push_back(std::move(ofBody));
  }
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

std::vector<Property> RobotCellDocument::propertiesOfBody(const Body& body) const {
  std::vector<Property> all = propertiesOf(body);
  const auto name =
      std::find_if(all.begin(), all.end(), [](const Property& each) { return each.id.ends_with(".name"); });
  all.insert(name == all.end() ? name : name + 1, carrierProperty(body, m_robot->model));
  return all;
}

std::optional<Property> RobotCellDocument::property(const std::string& id) const {
  if (const RobotPath* const path = pathOfClearance(*m_plans, id)) return clearanceProperty(*path, *m_plans);
  if (const auto waypoint = waypointOfProperty(*m_plans, id)) {
    for (const Property& each : waypointProperties(*m_plans->path(waypoint->path), waypoint->index)) {
      if (each.id == id) return each;
    }
  }
  const auto ofFrame = fieldOfFrame(id), ofTarget = fieldOfTarget(id);
  if (ofFrame || ofTarget) {
    const NamedFrame* const frame = ofFrame ? m_plans->frame(ofFrame->name) : nullptr;
    const NamedTarget* const target = ofTarget ? m_plans->target(ofTarget->name) : nullptr;
    for (Property& each : frame    ? frameProperties(*frame, placement())
                          : target ? targetProperties(*target, placement())
                                   : std::vector<Property>()) {
      if (each.id == id) return each;
    }
    return std::nullopt;
  }
  const auto field = bodyFieldOf(id);
  const BodyPointer body = field ? bodyNamed(bodies(), field->body) : nullptr;
  const std::vector<Property> all = propertiesWith(body ? std::span(body.get(), 1) : std::span<const Body>());
  const std::string full = body ? "body." + std::to_string(body->id) + '.' + field->field : id;
  const auto found = std::find_if(all.begin(), all.end(), [&](const Property& each) { return each.id == full; });
  return found == all.end() ? std::nullopt : std::optional(*found);
}

Result<std::unique_ptr<Edit>> RobotCellDocument::propertyEdit(const std::string& id, const PropertyValue& value) const {
  if (const auto body = bodyOfProperty(id)) {
    if (!id.ends_with(".carrier")) return bodyPropertyEdit(bodies(), id, value);
    const auto* choice = std::get_if<double>(&value);
    if (!choice || !(*choice >= 0.0 && *choice <= static_cast<double>(m_robot->model.links.size())))
      return Error{ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
    const std::uint32_t link = *choice < 1.0 ? kNone : static_cast<std::uint32_t>(*choice) - 1;
    return carryEdit(bodies(), {*body}, link, m_robot->model, m_joints);
  }
  const std::string ofCentre = id.starts_with("tcp.") ? id.substr(4) : std::string();
  if (const auto centre = changedPose(m_plans->tool, ofCentre, value)) {
    CellPlans changed = *m_plans;
    changed.tool = *centre;
    return std::unique_ptr<Edit>(plansEdit(std::move(changed)));
  }
  if (const RobotPath* const path = pathOfClearance(*m_plans, id)) {
    Result<CellPlans> changed = changedClearance(*m_plans, *path, value);
    if (!changed) return changed.error();
    return std::unique_ptr<Edit>(plansEdit(std::move(changed).value()));
  }
  if (const auto waypoint = waypointOfProperty(*m_plans, id)) {
    Result<CellPlans> changed = changedWaypoint(*m_plans, *waypoint, value);
    if (!changed) return changed.error();
    return std::unique_ptr<Edit>(plansEdit(std::move(changed).value()));
  }
  if (id == "frame" || id.starts_with("frame.") || id.starts_with("target.")) {
    Result<CellPlans> changed = changedFrameOrTarget(id, value, placement());
    if (!changed) return changed.error();
    return std::unique_ptr<Edit>(plansEdit(std::move(changed).value()));
  }
  if (isRateProperty(id)) {
    Result<CellPlans> changed = changedRate(*m_plans, id, value);
    if (!changed) return changed.error();
    return std::unique_ptr<Edit>(plansEdit(std::move(changed).value()));
  }
  if (isMissingProperty(id)) {
    Result<CellPlans> changed = changedMissing(id, value, *m_robot, bodies(), *m_plans);
    if (!changed) return changed.error();
    return std::unique_ptr<Edit>(plansEdit(std::move(changed).value()));
  }
  if (id == "arm") return armEdit(id, value);
  if (const auto base = baseOfProperty(*m_robot, id)) return baseEdit(*base, id, value);
  const Pose tool = toolPose(*m_robot, *m_plans, m_joints);
  const std::string field = id.starts_with("tool.") ? id.substr(5) : std::string();
  if (const auto pose = changedPose(tool, field, value)) {
    if (pose->isApprox(tool, 1e-12)) return std::unique_ptr<Edit>();
    const Result<JointValues> joints = jointsReaching(*m_robot, *m_plans, *pose, m_joints);
    if (!joints) return joints.error();
    return jointEdit(*joints);
  }
  const std::uint32_t dof = dofOfProperty(m_robot->model, id);
  if (dof == kNone) return Document::propertyEdit(id, value);
  const Result<double> wanted = jointValueFrom(m_robot->model, dof, value);
  if (!wanted) return wanted.error();
  JointValues joints = m_joints;
  joints[dof] = *wanted;
  return jointEdit(joints);
}

std::unique_ptr<Edit> RobotCellDocument::jointEdit(const JointValues& joints) const {
  const JointValues kept = withinLimits(m_robot->model, joints);
  std::vector<JointEdit::Move> moves;
  for (std::uint32_t dof = 0; dof < m_robot->model.dofs.size(); ++dof) {
    if (kept[dof] != m_joints[dof]) moves.push_back({dof, kept[dof]});
  }
  if (moves.empty()) return nullptr;
  return std::make_unique<JointEdit>(std::move(moves));
}

Result<std::unique_ptr<Edit>> RobotCellDocument::armEdit(const std::string& id, const PropertyValue& value) const {
  const auto* const number = std::get_if<double>(&value);
  if (!number || !(*number >= 0.0 && *number < static_cast<double>(m_robot->arms.size())))
    return Error{ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
  Result<CellPlans> plans = withArmChosen(*m_robot, *m_plans, m_robot->arms[static_cast<std::size_t>(*number)].name);
  if (!plans) return plans.error();
  return std::unique_ptr<Edit>(plansEdit(std::move(plans).value()));
}

Result<std::unique_ptr<Edit>> RobotCellDocument::baseEdit(const BaseField& base, const std::string& id,
                                                          const PropertyValue& value) const {
  const Pose present = basePose(m_robot->model, m_robot->arms[base.arm]);
  const auto pose = changedPose(present, base.field, value);
  if (!pose) return Error{ErrorCode::ElementMalformed, {id, "a number was expected"}, {}, {}};
  if (pose->isApprox(present, 1e-15)) return std::unique_ptr<Edit>();
  const auto now = std::static_pointer_cast<const RobotCellSnapshot>(snapshot());
  Result<RobotCellSnapshot> changed = withRobotMoved(*now, base.arm, *pose);
  if (!changed) return changed.error();
  return robotsEdit(std::move(changed).value(), base.arm);
}

std::unique_ptr<Edit> RobotCellDocument::robotsEdit(RobotCellSnapshot changed, std::optional<std::size_t> moved) const {
  std::vector<BodyEdit::Change> bodies;
  for (const BodyPointer& body : changed.bodies) {
    if (this->bodies().withId(body->id) != body) bodies.push_back({body->id, body});
  }
  return std::make_unique<RobotsEdit>(std::move(changed), std::move(bodies), moved);
}

std::unique_ptr<Edit> RobotCellDocument::plansEdit(CellPlans plans) const {
  if (plans == *m_plans) return nullptr;
  return std::make_unique<PlansEdit>(std::make_shared<const CellPlans>(std::move(plans)));
}

}  // namespace handwheel
