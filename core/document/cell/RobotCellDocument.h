// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "document/cell/CellFrames.h"
#include "document/cell/RobotCellSnapshot.h"
#include "document/scene/BodyOwner.h"

#include <span>

namespace handwheel {

struct BaseField;

// Document of a robot cell: robots with their joint values, and the bodies beside them.
class RobotCellDocument : public Document, public BodyOwner {
  Q_OBJECT

 public:
  // opened: the content is a RobotCellSnapshot.
  explicit RobotCellDocument(OpenedFile opened, QObject* parent = nullptr);

  const CellRobot& robot() const { return *m_robot; }
  const JointValues& joints() const { return m_joints; }
  const std::shared_ptr<const CellPlans>& plans() const { return m_plans; }  // never null

  // What verifications found of the paths, and of what state of the cell: it is stored with it, and no edit.
  const PathProofs& proofs() const { return *m_proofs; }
  // isChange: the document is modified then; else the next save takes it along.
  void setProofs(PathProofs proofs, bool isChange);

  SnapshotPointer snapshot() const override;
  // Those of cellProperties(), of bodyProperties(), of the frames and targets, then those of every document.
  std::vector<Property> properties() const override;
  // Of the bodies those of these only: there may be very many.
  std::vector<Property> propertiesWith(std::span<const Body> shown) const;
  // Those of one body: of propertiesOf(), and what carries it.
  std::vector<Property> propertiesOfBody(const Body& body) const;
  // Where its frames and targets are.
  CellPlacement placement() const { return {*m_plans, bodies(), m_robot->model, m_joints}; }
  // A body may be named by its name, too: "body.Table.x"; the property then has the id with the number.
  std::optional<Property> property(const std::string& id) const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

  // An edit that moves the joints there, kept within their limits; null when nothing moves. Values must be finite.
  std::unique_ptr<Edit> jointEdit(const JointValues& joints) const;
  // An edit that makes these the plans; null when they are the same.
  std::unique_ptr<Edit> plansEdit(CellPlans plans) const;
  // An edit that makes these the robots, with their joints, plans and what they carry (RobotChanges.h). The bodies must
  // be those of the document, at most changed. moved: the number of the robot that is only moved.
  std::unique_ptr<Edit> robotsEdit(RobotCellSnapshot changed, std::optional<std::size_t> moved = {}) const;

 private:
  friend class JointEdit;
  friend class PlansEdit;
  friend class RobotsEdit;
  void bodiesChanged() override { wasChanged(); }

  Result<std::unique_ptr<Edit>> armEdit(const std::string& id, const PropertyValue& value) const;
  Result<std::unique_ptr<Edit>> baseEdit(const BaseField& base, const std::string& id,
                                         const PropertyValue& value) const;

  std::shared_ptr<const CellRobot> m_robot;
  JointValues m_joints;
  std::shared_ptr<const CellPlans> m_plans;
  std::shared_ptr<const PathProofs> m_proofs;
  std::string m_source;
};

}  // namespace handwheel
