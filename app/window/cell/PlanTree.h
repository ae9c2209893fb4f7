// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/cell/CellTargets.h"
#include "window/cell/PathStatus.h"

#include <QTreeWidget>
#include <map>

namespace handwheel {

// A tree of the planned content of a cell. It lists configurations, paths with their waypoints, and targets, frames if
// there are any, and robots if there are several. The tree only requests changes.
class PlanTree : public QTreeWidget {
  Q_OBJECT

 public:
  // The identification of a row.
  struct Entry {
    enum class Kind { None, Configuration, Path, Waypoint, Target, Frame, Robot };
    Kind kind = Kind::None;
    std::string name;          // Name of the configuration, target, frame, path, or robot
    std::size_t waypoint = 0;  // Index of the waypoint in the path
    bool operator==(const Entry&) const = default;
  };

  explicit PlanTree(QWidget* parent = nullptr);

  // Sets the content. robot: null if there is no cell. statuses: the verification states by the names of the paths.
  // reach: the reachability by the names of the targets. remarks: remarks by the names of the frames.
  void setPlans(const CellPlans& plans, const CellRobot* robot, const std::map<std::string, PathStatus>& statuses,
                const std::map<std::string, TargetReach>& reach, const std::map<std::string, QString>& remarks = {});
  Entry current() const;
  void select(const Entry& entry);

 signals:
  void currentChanged();
  void activated(const handwheel::PlanTree::Entry& entry);  // Emitted at a double click or the key Return
  void renameRequested(const handwheel::PlanTree::Entry& entry, const QString& name);
  void removalRequested();

 protected:
  void closeEditor(QWidget* editor, QAbstractItemDelegate::EndEditHint hint) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  Entry entryOf(const QTreeWidgetItem* item) const;
  void shareColumns();
  void addRobots(const CellPlans& plans, const CellRobot& robot);
  QTreeWidgetItem* add(QTreeWidgetItem* parent, const Entry& entry, const QString& text, const QString& status);

  bool m_isFilling = false;
  Entry m_renamed;  // Entry whose editor is about to close
  QString m_newName;
};

}  // namespace handwheel
