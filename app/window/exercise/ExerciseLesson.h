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

// The panel with which a student works on an exercise. It has the task, sizes of the drawing, steps with their hints,
// time, sizes as measured, handing in.
class ExerciseLesson : public QWidget {
  Q_OBJECT

 public:
  explicit ExerciseLesson(QWidget* parent = nullptr);

  // isRunning: the work has begun.
  void setExercise(const ExerciseSnapshot& shown, const Attempt& attempt, bool isRunning);
  void setSeconds(double seconds, double allowed);
  // Ticks the steps whose marks are met, and no others of those that have any.
  void setMet(const ExerciseSnapshot& measured, const Marking& marking);
  // Shows each size of the drawing; the ticks stay.
  void setMeasured(const ExerciseSnapshot& exercise, const Marking& marking);
  // The part is another one than was measured: the sizes stay, but look old.
  void setOutdated();

 signals:
  void begun();
  void hintTaken(std::size_t step, std::size_t count);  // so many of the step were looked at
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
  bool m_isMeasured = false;  // the sizes are those of the part as it is
};

// Whether all criteria of a step are met; false for a step without any.
bool isMet(const ExerciseStep& step, const Marking& marking);

}  // namespace handwheel
