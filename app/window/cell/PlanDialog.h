// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "controls/property/PropertyList.h"
#include "tools/cell/path/PlanOperation.h"

#include <QDialog>

class QLabel;
class QListWidget;
class QPushButton;

namespace handwheel {

// A dialog that asks for a path. It asks for its ends, the configurations in between, and the options of planning.
class PlanDialog : public QDialog {
  Q_OBJECT

 public:
  // robot: the robots of the cell. before: the values of the previous path; all but ends and name are offered again.
  PlanDialog(const CellRobot& robot, const CellPlans& plans, const FidelityValues& fidelity,
             const std::optional<OperationValues>& before, LengthUnit unit, QWidget* parent);

 signals:
  void chosen(const handwheel::OperationValues& values);

 private:
  void showValues();
  void accept() override;
  void keyPressEvent(QKeyEvent* event) override;

  std::vector<std::string> m_waypoints;  // Names that can be chosen, "here" first
  OperationValues m_values;
  double m_clearance;     // mm, clearance of the cell
  bool m_hasPlainShapes;  // True if the robot has simplified shapes
  PropertyList* m_list;
  QListWidget* m_via;
  QLabel* m_remark;
  QPushButton* m_plan;
};

}  // namespace handwheel
