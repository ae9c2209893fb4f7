// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "window/cell/CellTargets.h"
#include "window/cell/PathStatus.h"

#include <QTreeWidget>
#include <map>

namespace handwheel {

// A tree of the planned content of a cell. It lists its configurations, its paths with their places, its targets, its
// frames where it has some, and its robots where it has several. It only asks for changes.
class PlanTree : public QTreeWidget {
  Q_OBJECT

 public:
  // What a row stands for.
  struct Entry {
    enum class Kind { None, Configuration, Path, Place, Target, Frame, Robot };
    Kind kind = Kind::None;
    std::string name;       // of the configuration, the target, the frame, the path, or the robot
    std::size_t place = 0;  // in the path
    bool operator==(const Entry&) const = default;
  };

  explicit PlanTree(QWidget* parent = nullptr);

  // statuses: what is known of each path, by its name; reach: of targets; remarks: on frames. robot: null where there
  // is no cell.
  void setPlans(const CellPlans& plans, const CellRobot* robot, const std::map<std::string, PathStatus>& statuses,
                const std::map<std::string, TargetReach>& reach, const std::map<std::string, QString>& remarks = {});
  Entry current() const;
  void select(const Entry& entry);

 signals:
  void currentChanged();
  void activated(const handwheel::PlanTree::Entry& entry);  // by a double click or Return
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
  Entry m_renamed;  // by the editor that is about to close
  QString m_newName;
};

}  // namespace handwheel
