// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/CellFrames.h"
#include "document/cell/CellReach.h"
#include "window/cell/CellCollisions.h"

#include <map>

namespace handwheel {

class PathLayer;

// The reachability of a target by the tool.
struct TargetReach {
  bool isFree = false;
  QString remark;  // "out of reach"
};

// The targets of the current cell, drawn as axes like its frames, and their reachability. A worker computes the
// reachability. The functions must be called on the window thread.
class CellTargets : public QObject {
  Q_OBJECT

 public:
  CellTargets(const WindowContext& parts, CellCollisions& collisions, QObject* parent);
  ~CellTargets() override;

  void setDocument(DocumentTab* document);
  void setVisible(bool isVisible);
  // Sets the selected target and frame by their names; empty: none. The selected ones have longer axes.
  void setSelected(const std::string& target, const std::string& frame);
  // Returns the reachability by the names of the targets, as far as it is already computed.
  const std::map<std::string, TargetReach>& reach() const { return m_reach; }

 signals:
  void reachChanged();

 private:
  // The inputs of the reachability of the targets.
  struct Question {
    std::shared_ptr<const CellScene> scene;
    std::vector<NamedTarget> targets;
    std::vector<NamedFrame> frames;
    Pose tool = Pose::Identity();
    double clearance = 0.0;
    JointValues joints;  // The joint values if a robot carries the body of a target; otherwise empty
    bool operator==(const Question& other) const;
  };

  const RobotCellDocument& cell() const;
  Question question() const;
  void look();
  void show();

  WindowContext m_parts;
  CellCollisions& m_collisions;
  DocumentTab* m_document = nullptr;
  std::shared_ptr<PathLayer> m_layer;
  Question m_asked;
  std::map<std::string, TargetReach> m_reach;
  std::string m_selectedTarget, m_selectedFrame;
};

}  // namespace handwheel
