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

// Document of a robot cell. It contains the robots with their joint values, and the bodies.
class RobotCellDocument : public Document, public BodyOwner {
  Q_OBJECT

 public:
  // opened: an opened file, whose content must be a RobotCellSnapshot.
  explicit RobotCellDocument(OpenedFile opened, QObject* parent = nullptr);

  const CellRobot& robot() const { return *m_robot; }
  const JointValues& joints() const { return m_joints; }
  const std::shared_ptr<const CellPlans>& plans() const { return m_plans; }  // Never null

  // Returns the findings of path verifications with the digests of their inputs. They are stored with the cell;
  // changing them is no edit.
  const PathProofs& proofs() const { return *m_proofs; }
  // Sets the findings of path verifications. isChange: marks the document as modified; otherwise the findings are saved
  // only when the document is saved for another reason.
  void setProofs(PathProofs proofs, bool isChange);

  SnapshotPointer snapshot() const override;
  // Returns the properties of the cell (cellProperties()), of the bodies (bodyProperties()), of the frames and targets,
  // and of every document.
  std::vector<Property> properties() const override;
  // Returns the same properties as properties(), but of the bodies only those of `shown`, as a cell may have very many.
  std::vector<Property> propertiesWith(std::span<const Body> shown) const;
  // Returns the properties of one body: propertiesOf() and its carrier.
  std::vector<Property> propertiesOfBody(const Body& body) const;
  // Returns the data that the poses of frames and targets depend on.
  CellPlacement placement() const { return {*m_plans, bodies(), m_robot->model, m_joints}; }
  // Returns a property. A body may also be given by its name, "body.Table.x"; the id of the result contains the number.
  std::optional<Property> property(const std::string& id) const override;
  Result<std::unique_ptr<Edit>> propertyEdit(const std::string& id, const PropertyValue& value) const override;

  // Makes an edit that moves the joints to these values, clamped to their limits. Returns null if nothing moves. The
  // values must be finite.
  std::unique_ptr<Edit> jointEdit(const JointValues& joints) const;
  // Makes an edit that replaces the plans. Returns null if they are the same.
  std::unique_ptr<Edit> plansEdit(CellPlans plans) const;
  // Makes an edit that replaces the robots, with their joints, plans and the bodies that they carry (RobotChanges.h).
  // The bodies must be those of the document, at most changed. moved: the number of the robot, if moving this robot is
  // the only change.
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
