// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // moc cannot read <numbers>, which Units.h includes, without this before it

#include "controls/property/PropertyList.h"
#include "document/exercise/RoundTarget.h"
#include "window/JobRunner.h"

#include <QDialog>

class QLabel;
class QPushButton;

namespace handwheel {

// A dialog to round an exercise's target, with a preview of the change. The rounding runs as a job.
class RoundTargetDialog : public QDialog {
  Q_OBJECT

 public:
  // Subject and pool must outlive the dialog.
  RoundTargetDialog(const ExerciseSubject& subject, TaskPointer task, QThreadPool& pool, QWidget* parent);

 signals:
  void chosen(const handwheel::TaskPointer& task);

 private:
  void showValues();
  void showRounded(const Result<ExerciseSubject::RoundedTask>& rounded);
  void accept() override;

  const ExerciseSubject& m_subject;
  TaskPointer m_task;
  OperationValues m_values;
  TaskPointer m_rounded;  // null: the values are impossible, or not tried yet
  PropertyList* m_list;
  QLabel* m_remark;
  QPushButton* m_round;
  JobRunner m_jobs;
};

}  // namespace handwheel
