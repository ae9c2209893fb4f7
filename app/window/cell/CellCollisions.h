// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/CellContacts.h"
#include "window/kinds/KindUi.h"

#include <set>

namespace handwheel {

class RobotCellDocument;

// The collisions in the current cell, at present and while the robot is dragged. A worker prepares the cell whenever
// its robot, bodies or allowed pairs have changed. The functions must be called on the window thread.
class CellCollisions : public QObject {
  Q_OBJECT

 public:
  CellCollisions(const WindowContext& parts, QObject* parent);

  void setDocument(DocumentTab* document);
  // Returns the present cell prepared for planning with the robot that is planned for; null while the cell is being
  // prepared, or if that is impossible.
  std::shared_ptr<const CellScene> scene() const;
  // Returns the present cell prepared for planning with another robot, given by its number. The result is also null
  // while the scenes of other robots are being prepared.
  std::shared_ptr<const CellScene> sceneFor(std::size_t arm) const;
  // Returns true if the cell is prepared for all robots.
  bool isReady() const { return m_document && isPrepared() && areOthersPrepared(); }
  const std::shared_ptr<CollisionMeshes>& meshes() const { return m_meshes; }
  // Prepares the cell if its preparation was cancelled. Clients call this function if they need scene() and it is null.
  void prepareIfIdle();

  // Colours the collisions of a displayed cell: those of the robot at these joint values, or, if `moved` is not null,
  // only those of this body, which is being moved. Does nothing while the cell is not prepared. Returns the collisions.
  std::vector<CellCollision> mark(DisplayModel& shown, const JointValues& joints, const Body* moved = nullptr) const;
  // Colours the collisions of a displayed cell while a robot is moved as a whole by this displacement, with all bodies
  // that it carries. If this takes longer than a frame, the remaining parts keep their colour. Returns the collisions.
  std::vector<CellCollision> markMoved(DisplayModel& shown, std::size_t robot, const Pose& displacement) const;

 signals:
  void prepared();

 private:
  const RobotCellDocument& cell() const;
  bool isOfPresentRobots() const;
  bool isPrepared() const;
  bool areOthersPrepared() const;
  std::shared_ptr<const CellScene> sceneMoving(const JointValues& joints) const;
  void prepare();

  WindowContext m_parts;
  std::shared_ptr<CollisionMeshes> m_meshes;
  DocumentTab* m_document = nullptr;
  std::shared_ptr<const CellScene> m_scene;
  bool m_isUnderWay = false;
  // Scenes of the other robots, in order, for collisions while these robots are dragged. An element is null if its
  // preparation failed. Until they are replaced, the scenes may have former joint values.
  std::vector<std::shared_ptr<const CellScene>> m_others;
  std::shared_ptr<const CellPlans> m_plans;  // Plans of the cell when m_scene was made
};

}  // namespace handwheel
