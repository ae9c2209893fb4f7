// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/RunningAttempt.h"

#include "document/exercise/Submission.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/exercise/ExerciseLesson.h"

#include <QDockWidget>
#include <QMainWindow>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kTickMs = 500;

}  // namespace

RunningAttempt::RunningAttempt(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_lesson(new ExerciseLesson(parts.window)) {
  m_lesson->setObjectName(QStringLiteral("exerciseLesson"));
  if (auto* window = qobject_cast<QMainWindow*>(parts.window)) {
    m_dock = new QDockWidget(tr("Lesson"), window);
    m_dock->setObjectName(QStringLiteral("lessonDock"));
    m_dock->setAccessibleName(tr("Lesson"));
    m_dock->setWidget(m_lesson);
    m_dock->setTitleBarWidget(new DockTitle(m_dock));
    window->addDockWidget(Qt::LeftDockWidgetArea, m_dock);
    m_dock->hide();
  }
  connect(&parts.tabs, &DocumentTabs::currentChanged, this, &RunningAttempt::follow);
  connect(&parts.tabs, &DocumentTabs::closing, this, [this](DocumentTab* closing) {
    if (closing != m_work) return;
    m_work = nullptr;
    m_clock.stop();
    if (m_dock) m_dock->hide();
    emit changed();
  });
  connect(&m_clock, &QTimer::timeout, this, &RunningAttempt::tick);
  connect(m_lesson, &ExerciseLesson::measuringRequested, this, &RunningAttempt::measure);
  connect(m_lesson, &ExerciseLesson::handInRequested, this, &RunningAttempt::handIn);
  connect(m_lesson, &ExerciseLesson::hintsTaken, this, [this](std::size_t step) {
    m_attempt.hints.resize(std::max(m_attempt.hints.size(), step + 1));
    m_attempt.hints[step] = m_exercise->exercise.steps[step].hints.size();
  });
  connect(m_lesson, &ExerciseLesson::stepDone, this, [this](std::size_t step) { setDone(step, true); });
}

void RunningAttempt::begin(std::shared_ptr<const ExerciseSnapshot> exercise) {
  if (m_work && m_exercise && m_exercise->key == exercise->key) {
    showDock();
    return m_parts.tabs.setCurrent(m_work);
  }
  m_clock.stop();
  m_exercise = std::move(exercise);
  m_attempt = m_exercise->attempt.value_or(Attempt());
  m_attempt.handedIn.clear();
  if (m_attempt.begun.empty()) m_attempt.begun = presentTime();
  const DocumentKind* kind = m_parts.kinds.withId(m_exercise->subject->kind().id());
  OpenedFile opened = DocumentKinds::blank(*kind);
  opened.content = m_exercise->work ? m_exercise->work : m_exercise->subject->start(*m_exercise->task);
  m_work = nullptr;
  DocumentTab* work = m_parts.openDocument(std::move(opened));
  m_work = work;
  showDock();
  showLesson();
  follow(m_parts.tabs.current());
  emit changed();
}

void RunningAttempt::showDock() {
  if (!m_dock) return;
  m_dock->show();
  m_dock->raise();
}

void RunningAttempt::showLesson() {
  if (m_exercise) m_lesson->setExercise(m_exercise->exercise, m_attempt, isRunning());
}

void RunningAttempt::setDone(std::size_t step, bool isDone) {
  m_attempt.done.resize(std::max(m_attempt.done.size(), step + 1));
  m_attempt.done[step] = isDone;
}

void RunningAttempt::follow(DocumentTab* current) {
  if (m_work && current == m_work) {
    if (m_clock.isActive()) return;
    m_since.start();
    m_clock.start(kTickMs);
  } else {
    if (m_clock.isActive()) tick();
    m_clock.stop();
  }
}

void RunningAttempt::tick() {
  m_attempt.seconds += static_cast<double>(m_since.restart()) / 1000.0;
  m_lesson->setSeconds(m_attempt.seconds, m_exercise->exercise.allowedSeconds);
}

void RunningAttempt::measure() {
  if (!m_work) return;
  Job job;
  job.name = tr("Measuring");
  job.owner = &m_work->document;
  job.work = [this, exercise = m_exercise, work = m_work->document.snapshot(), attempt = m_attempt](Progress progress) {
    auto marking = std::make_shared<Marking>(markWork(*exercise, *work, attempt, progress));
    return Job::Finish([this, exercise, marking] {
      if (exercise != m_exercise) return;
      for (std::size_t i = 0; i < exercise->exercise.steps.size(); ++i) {
        const ExerciseStep& step = exercise->exercise.steps[i];
        if (!step.criteria.empty()) setDone(i, isMet(step, *marking));
      }
      m_lesson->setMeasured(exercise->exercise, *marking);
    });
  };
  m_parts.jobs.start(std::move(job));
}

// What is handed in is a document, which is saved where the student chooses.
void RunningAttempt::handIn(const QString& student) {
  if (!m_work) return;
  if (m_clock.isActive()) tick();
  Attempt attempt = m_attempt;
  attempt.student = student.toStdString();
  Result<ExerciseSnapshot> submission = handedIn(*m_exercise, m_work->document.snapshot(), std::move(attempt));
  if (!submission) {
    emit message({Message::Weight::Error, tr("It could not be handed in"), errorSentence(submission.error()),
                  errorAdvice(submission.error())});
    return;
  }
  const DocumentKind* kind = m_parts.kinds.withId("exercise");
  OpenedFile opened = DocumentKinds::blank(*kind);
  opened.file.recordings = m_work->document.file().recordings;
  opened.content = std::make_shared<const ExerciseSnapshot>(std::move(submission.value()));
  m_parts.openDocument(std::move(opened));
  m_parts.saveAs->trigger();
}

}  // namespace handwheel
