// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;

namespace handwheel {

class LessonPanel;
class ScrolledPanel;

// The panel with which a student works on an exercise. It shows the task, the sizes of the drawing, the steps with
// their hints, the time and the measured sizes, and has a button to submit the work.
class ExerciseLesson : public QWidget {
  Q_OBJECT

 public:
  explicit ExerciseLesson(QWidget* parent = nullptr);

  // Shows an exercise and an attempt at it. isRunning: true if the work has begun.
  void setExercise(const ExerciseSnapshot& shown, const Attempt& attempt, bool isRunning);
  void setSeconds(double seconds, double allowed);
  // Ticks the steps whose criteria are met. All other steps with criteria are unticked.
  void setMet(const ExerciseSnapshot& measured, const Marking& marking);
  // Shows the measured value of each size of the drawing; the ticks are unchanged.
  void setMeasured(const ExerciseSnapshot& exercise, const Marking& marking);
  // Marks the measured sizes as outdated, because the part has changed.
  void setOutdated();

 signals:
  void begun();
  void hintTaken(std::size_t step, std::size_t count);  // count: number of hints of the step that were shown
  void stepDone(std::size_t step);
  void measuringRequested();
  void nameChanged(const QString& student);
  void handInRequested(const QString& student);

 private:
  void followName();

  QLabel* m_text;
  QPushButton* m_begin;
  LessonPanel* m_steps;
  ScrolledPanel* m_reading;
  QLabel* m_sizes;
  QPushButton* m_measure;
  QLineEdit* m_name;
  QPushButton* m_handIn;
  bool m_isRunning = false;
  bool m_isMeasured = false;  // true: the shown sizes were measured on the present part
};

// Returns true if all criteria of a step are met; false for a step without criteria.
bool isMet(const ExerciseStep& step, const Marking& marking);

}  // namespace handwheel
