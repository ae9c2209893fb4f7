// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "controls/property/PropertyList.h"
#include "tools/cell/path/PlanOperation.h"

#include <QDialog>

class QLabel;
class QListWidget;
class QPushButton;

namespace handwheel {

// A dialog that asks for a path. The user chooses its ends, the configurations in between, and the options of planning.
class PlanDialog : public QDialog {
  Q_OBJECT

 public:
  // robot: the robots of the cell. before: the values of the previous path, which are proposed again except for ends
  // and name.
  PlanDialog(const CellRobot& robot, const CellPlans& plans, const FidelityValues& fidelity,
             const std::optional<OperationValues>& before, LengthUnit unit, QWidget* parent);

 signals:
  void chosen(const handwheel::OperationValues& values);

 private:
  void showValues();
  void accept() override;
  void keyPressEvent(QKeyEvent* event) override;

  std::vector<std::string> m_waypoints;  // Names that can be chosen; the first is "here", the present joint values
  OperationValues m_values;
  double m_clearance;     // mm, clearance of the cell
  bool m_hasPlainShapes;  // True if the robot has simplified shapes
  PropertyList* m_list;
  QListWidget* m_via;
  QLabel* m_remark;
  QPushButton* m_plan;
};

}  // namespace handwheel
