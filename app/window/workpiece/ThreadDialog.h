// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "controls/property/PropertyList.h"
#include "tools/workpiece/ThreadOperation.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace handwheel {

// A dialog that asks for a thread: its range, pitch and form. It shows problems at once.
class ThreadDialog : public QDialog {
  Q_OBJECT

 public:
  ThreadDialog(const WorkpieceSnapshot& workpiece, LengthUnit unit, QWidget* parent);

 signals:
  void chosen(const handwheel::TurningPass& pass);

 private:
  void showValues();
  void accept() override;

  WorkpieceSnapshot m_workpiece;
  OperationValues m_values;
  LengthUnit m_unit;
  PropertyList* m_list;
  QLabel* m_remark;
  QPushButton* m_cut;
};

}  // namespace handwheel
