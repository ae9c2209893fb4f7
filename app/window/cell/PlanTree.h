// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/cell/CellTargets.h"
#include "window/cell/PathStatus.h"

#include <QTreeWidget>
#include <map>

namespace handwheel {

// A tree of the planned content of a cell. It lists its configurations, its paths with their waypoints, its targets,
// and if there are any its frames, and its robots if there are several. It only requests changes.
class PlanTree : public QTreeWidget {
  Q_OBJECT

 public:
  // The item of a row.
  struct Entry {
    enum class Kind { None, Configuration, Path, Waypoint, Target, Frame, Robot };
    Kind kind = Kind::None;
    std::string name;          // Name of the configuration, target, frame, path, or robot
    std::size_t waypoint = 0;  // Index of the waypoint in the path
    bool operator==(const Entry&) const = default;
  };

  explicit PlanTree(QWidget* parent = nullptr);

  // statuses: of the verification of each path, by its name; reach: of targets; remarks: on frames. robot: null if
  // there is no cell.
  void setPlans(const CellPlans& plans, const CellRobot* robot, const std::map<std::string, PathStatus>& statuses,
                const std::map<std::string, TargetReach>& reach, const std::map<std::string, QString>& remarks = {});
  Entry current() const;
  void select(const Entry& entry);

 signals:
  void currentChanged();
  void activated(const handwheel::PlanTree::Entry& entry);  // By a double click or Return
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
