// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/cell/CellCollisions.h"

#include <QAction>

namespace handwheel {

class PathLayer;

// The outline of the workspace of the current arm. The outline lies in the upright plane through the base of the arm
// and its tool. It is shown on demand and computed by a worker. The functions must be called on the window thread.
class CellReachOutline : public QObject {
  Q_OBJECT

 public:
  CellReachOutline(const WindowContext& parts, CellCollisions& collisions, QObject* parent);
  ~CellReachOutline() override;

  QAction* action() { return &m_action; }
  void setDocument(DocumentTab* document);
  void setVisible(bool isVisible);

 private:
  void look();

  WindowContext m_parts;
  CellCollisions& m_collisions;
  DocumentTab* m_document = nullptr;
  std::shared_ptr<PathLayer> m_layer;
  QAction m_action;
  // Inputs of the present outline.
  std::shared_ptr<const CellScene> m_scene;
  Pose m_tool = Pose::Identity();
  Vec3 m_direction = Vec3::Zero();  // Unit length; zero: no outline
};

}  // namespace handwheel
