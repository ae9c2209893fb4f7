// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/RobotCellDocument.h"

#include "document/cell/CellProperties.h"
#include "document/cell/JointEdit.h"
#include "document/scene/BodyProperties.h"

namespace handwheel {

RobotCellDocument::RobotCellDocument(OpenedFile opened, QObject* parent)
    : Document(*opened.kind, std::move(opened.file), parent),
      BodyOwner(static_cast<const RobotCellSnapshot&>(*opened.content).bodies) {
  const auto& content = static_cast<const RobotCellSnapshot&>(*opened.content);
  m_robot = content.robot;
  m_joints = content.joints;
  m_source = content.source;
}

SnapshotPointer RobotCellDocument::snapshot() const {
  auto snapshot = std::make_shared<RobotCellSnapshot>();
  snapshot->robot = m_robot;
  snapshot->joints = m_joints;
  snapshot->source = m_source;
  snapshot->bodies = bodies();
  return snapshot;
}

std::vector<Property> RobotCellDocument::properties() const {
  std::vector<Property> all = cellProperties(m_robot->model, m_joints);
  for (Property& ofBody : bodyProperties(bodies())) all.push_back(std::move(ofBody));
  for (Property& common : Document::properties()) all.push_back(std::move(common));
  return all;
}

Result<std::unique_ptr<Edit>> RobotCellDocument::propertyEdit(const std::string& id, const PropertyValue& value) const {
  if (bodyOfProperty(id)) return bodyPropertyEdit(bodies(), id, value);
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

}  // namespace handwheel
