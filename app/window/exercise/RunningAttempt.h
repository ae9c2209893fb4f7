// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/exercise/ExerciseSnapshot.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <chrono>

class QDockWidget;

namespace handwheel {

class ExerciseLesson;
class PanelToggle;

// The documents that are work on an exercise, and the panel with its steps. The panel is beside the current document.
// Exercise and attempt are kept in the document of the work, and so in its file and its autosave: who opens it goes on.
// The time runs while the document is the current one.
class RunningAttempt : public QObject {
  Q_OBJECT

 public:
  RunningAttempt(const WindowContext& parts, QObject* parent);

  // Opens what the student begins with, or continues with; shows the work that was begun from the same document before.
  // from: a student's or a teacher's document; neither is shown the work of the other.
  void begin(const DocumentTab& from);
  // The work that was begun from the exercise of a tab and was current last, or else any work on that exercise; null:
  // none is open.
  const DocumentTab* workOn(const DocumentTab& from) const;

 signals:
  void changed();  // which work there is
  void message(const handwheel::Message& message);

 private:
  using Clock = std::chrono::steady_clock;
  struct Work {
    void see();  // its document as it is

    DocumentTab* tab;
    std::shared_ptr<const ExerciseSnapshot> exercise;  // as the student has it
    Attempt attempt;
    std::shared_ptr<const ExerciseSnapshot> origin;  // that it was begun from in this window; null: from a file
    double secondsInFile = 0.0;
    int changes = 0;                                      // that were seen: tells what was measured before one
    std::shared_ptr<const Marking> sizes = nullptr;       // as measured last, on demand; null: not yet
    bool areSizesOld = false;                             // the work has gone on since
    std::uint64_t revision = 0;                           // of the document, that was seen
    std::weak_ptr<SnapshotPointer::element_type> seen{};  // likewise its value, of kinds that keep it
    bool isUnderWay = false;                              // something was seen that is not in the document yet
    bool isCheckDue = false;                              // of the steps, as soon as the tool has ended its call
    Clock::time_point nextCheck{};                        // what is under way is not checked before
  };
  Work* find(const DocumentTab* tab);
  Work* current() { return m_works.empty() || !m_isCurrent ? nullptr : &m_works.back(); }
  Work* begunFrom(const std::shared_ptr<const ExerciseSnapshot>& exercise, const DocumentFile& file,
                  const AssignedExercise& assigned);
  void prepare(const DocumentTab& from, const std::shared_ptr<const ExerciseSnapshot>& exercise, OpenedFile work);
  void start(const std::shared_ptr<const ExerciseSnapshot>& exercise, OpenedFile work);
  void connectLesson();
  void follow(DocumentTab* tab);
  bool take(DocumentTab* tab);
  void forget(DocumentTab* tab);
  void showDock(bool isShown);
  void show(const Work& work);
  void store(Work& work, bool isChange);
  void setDone(Work& work, std::size_t step, bool isDone);
  void tick();
  void followGesture(Work& work);
  void measure();
  void startMeasuring(Work& measured);
  void check();
  void recorded();
  void checkSteps(Work& checked);
  void outdate(Work& work);
  SnapshotPointer now(Work& work);
  void start(JobRunner& jobs, const QString& name, Work& measured, bool showsSizes);
  void take(const DocumentTab* tab, const ExerciseSnapshot& exercise, const std::shared_ptr<const Marking>& marking,
            bool showsSizes);
  void handIn();
  void writeSubmission(const QString& path);
  void fail(const QString& title, const Error& error);

  WindowContext m_parts;
  QDockWidget* m_dock = nullptr;
  PanelToggle* m_toggle = nullptr;  // of the dock, for the menu View and the search; enabled where there is a lesson
  ExerciseLesson* m_lesson;
  std::vector<Work> m_works;  // the one that was current last is the last
  bool m_isCurrent = false;   // the last of them is the current document
  bool m_isDockWanted = true;
  QElapsedTimer m_since;
  QTimer m_clock;
  JobRunner m_checks;                                   // of the steps, after each change of the work
  QMetaObject::Connection m_changes, m_records;         // of the current document
  bool m_isStoring = false;                             // what is recorded by then is known here
  std::shared_ptr<const ExerciseSnapshot> m_beginning;  // that a document is being opened for
  std::shared_ptr<const nlohmann::json> m_beginningAs;  // as that document has it
};

}  // namespace handwheel
