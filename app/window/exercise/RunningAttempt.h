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

// The open documents that are work on exercises, and the panel with the steps. The panel is beside the current
// document. The exercise and the attempt are stored in the document of the work, and therefore in its file and its
// autosave, from which the work can be continued. The working time runs while the document of the work is the current
// document.
class RunningAttempt : public QObject {
  Q_OBJECT

 public:
  RunningAttempt(const WindowContext& parts, QObject* parent);

  // Opens new work on the exercise, or shows the work that was begun from the same document before. from: the document
  // of a student or of a teacher; work begun from one of them is not shown for the other.
  void begin(const DocumentTab& from);
  // Returns the work that was begun from the exercise of a tab and was current last, or else any work on that exercise.
  // Returns null if no such work is open.
  const DocumentTab* workOn(const DocumentTab& from) const;

 signals:
  void changed();  // the set of open works has changed
  void message(const handwheel::Message& message);

 private:
  using Clock = std::chrono::steady_clock;
  struct Work {
    void see();  // records the present state of the document

    DocumentTab* tab;
    std::shared_ptr<const ExerciseSnapshot> exercise;  // the student's copy
    Attempt attempt;
    // exercise from which the work was begun in this window; null: the work was opened from a file
    std::shared_ptr<const ExerciseSnapshot> origin;
    double secondsInFile = 0.0;
    int changes = 0;                                      // number of changes seen, to detect outdated measurements
    std::shared_ptr<const Marking> sizes = nullptr;       // last marking on demand; null: none yet
    bool areSizesOld = false;                             // true: the work has changed since that marking
    std::uint64_t revision = 0;                           // revision of the document that was last seen
    std::weak_ptr<SnapshotPointer::element_type> seen{};  // snapshot of the document that was last seen
    bool isUnderWay = false;                              // true: an unfinished gesture is not in the document yet
    bool isCheckDue = false;        // true: the steps are checked as soon as control returns to the event loop
    Clock::time_point nextCheck{};  // earliest time of the next check during a gesture
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
  PanelToggle* m_toggle = nullptr;  // toggles the dock, for the menu View and the search; enabled if there is a lesson
  ExerciseLesson* m_lesson;
  std::vector<Work> m_works;  // the last one was current last
  bool m_isCurrent = false;   // true: the last work is the current document
  bool m_isDockWanted = true;
  QElapsedTimer m_since;
  QTimer m_clock;
  JobRunner m_checks;                                   // checks of the steps, after each change of the work
  QMetaObject::Connection m_changes, m_records;         // connections to the current document
  bool m_isStoring = false;                             // true: this object itself is changing the document
  std::shared_ptr<const ExerciseSnapshot> m_beginning;  // the exercise for which a document is being opened
  std::shared_ptr<const nlohmann::json> m_beginningAs;  // the description of m_beginning in that document
};

}  // namespace handwheel
