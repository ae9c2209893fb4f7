// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/CellContacts.h"
#include "window/kinds/KindUi.h"

#include <set>

namespace handwheel {

class RobotCellDocument;

// The collisions in the current cell, at present and while the robot is dragged. Prepares the cell on a worker whenever
// its robot, bodies or allowed pairs have changed. Window thread.
class CellCollisions : public QObject {
  Q_OBJECT

 public:
  CellCollisions(const WindowContext& parts, QObject* parent);

  void setDocument(DocumentTab* document);
  // Returns the present cell prepared for planning with the robot that is planned for; null while it is being prepared,
  // or if that is impossible.
  std::shared_ptr<const CellScene> scene() const;
  // Returns the same for another robot, by its number; also null while the other robots are being prepared.
  std::shared_ptr<const CellScene> sceneFor(std::size_t arm) const;
  bool isReady() const { return m_document && isPrepared() && areOthersPrepared(); }  // True if prepared for all robots
  const std::shared_ptr<CollisionMeshes>& meshes() const { return m_meshes; }
  // Prepares the cell if that was cancelled. Called by any client that needs scene() while it is null.
  void prepareIfIdle();

  // Colours the collisions of a displayed cell: of the robot at these joint values, or if a body is being moved (null:
  // none) of that body alone. Does nothing while the cell is not prepared. Returns the collisions.
  std::vector<CellCollision> mark(DisplayModel& shown, const JointValues& joints, const Body* moved = nullptr) const;
  // Does the same while a robot is moved as a whole by this displacement, with all bodies that it carries. If this
  // takes longer than a frame, the rest keeps its colour.
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
  // Scenes of the other robots, in order, for collisions while these are dragged. Null if preparing failed. Until they
  // are replaced they may be of former joint values.
  std::vector<std::shared_ptr<const CellScene>> m_others;
  std::set<std::pair<std::string, std::string>> m_allowed;  // Allowed pairs of m_scene
};

}  // namespace handwheel
