// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/cell/CellContacts.h"
#include "window/kinds/KindUi.h"

#include <set>

namespace handwheel {

class RobotCellDocument;

// What collides in the cell in view, now and while the robot is dragged. Prepares the cell on a worker whenever its
// robot, bodies or allowed pairs have changed. Window thread.
class CellCollisions : public QObject {
  Q_OBJECT

 public:
  CellCollisions(const WindowContext& parts, QObject* parent);

  void setDocument(DocumentTab* document);
  // The cell prepared for planning with the robot that is planned for, as it is now; null while that is under way, or
  // impossible.
  std::shared_ptr<const CellScene> scene() const;
  // The same for another robot, by its number; null, too, while the other ones are being prepared.
  std::shared_ptr<const CellScene> sceneFor(std::size_t arm) const;
  bool isReady() const { return m_document && isPrepared() && areOthersPrepared(); }  // for all robots
  const std::shared_ptr<CollisionMeshes>& meshes() const { return m_meshes; }
  // Prepares the cell if that was cancelled. Whoever needs scene() and has none calls it.
  void prepareIfIdle();

  // Colours what collides in a cell that is shown: the robot at these joint values, where a body is being moved (null:
  // none is) with that alone. Nothing, while the cell is not prepared. Returns what was found.
  std::vector<CellCollision> mark(DisplayModel& shown, const JointValues& joints, const Body* moved = nullptr) const;
  // The same where a robot is moved as a whole, so far, with all that it carries. Where that takes longer than a frame
  // may, the rest stays as it is.
  std::vector<CellCollision> markMoved(DisplayModel& shown, std::size_t robot, const Pose& way) const;

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
  // The same for the other robots, in order: what collides while these are dragged. Null where that is impossible.
  // Until new ones come they may be of former joint values.
  std::vector<std::shared_ptr<const CellScene>> m_others;
  std::set<std::pair<std::string, std::string>> m_allowed;  // that m_scene was made with
};

}  // namespace handwheel
