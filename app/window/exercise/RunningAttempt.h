// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"
#include "window/kinds/KindUi.h"

#include <QElapsedTimer>
#include <QTimer>

class QDockWidget;

namespace handwheel {

class ExerciseLesson;

// A student's attempt at an exercise while it is done: the document that is worked on, the steps beside it, the time.
// The time runs while that document is the current one.
class RunningAttempt : public QObject {
  Q_OBJECT

 public:
  RunningAttempt(const WindowContext& parts, QObject* parent);

  // Opens what the student begins with, or continues with. exercise: of a student's or a teacher's document.
  void begin(std::shared_ptr<const ExerciseSnapshot> exercise);
  bool isRunning() const { return m_work != nullptr; }
  // The document that is worked on; null: none.
  const DocumentTab* work() const { return m_work; }
  const ExerciseSnapshot* exercise() const { return m_exercise.get(); }

 signals:
  void changed();
  void message(const handwheel::Message& message);

 private:
  void showDock();
  void showLesson();
  void setDone(std::size_t step, bool isDone);
  void follow(DocumentTab* current);
  void tick();
  void measure();
  void handIn(const QString& student);

  WindowContext m_parts;
  QDockWidget* m_dock = nullptr;
  ExerciseLesson* m_lesson;
  std::shared_ptr<const ExerciseSnapshot> m_exercise;
  DocumentTab* m_work = nullptr;
  Attempt m_attempt;
  QElapsedTimer m_since;
  QTimer m_clock;
};

}  // namespace handwheel
