// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/RunningAttempt.h"

#include "document/exercise/ExerciseDocument.h"
#include "document/exercise/ShippedExercises.h"
#include "document/exercise/StartedWork.h"
#include "document/exercise/Submission.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "window/JobRunner.h"
#include "window/PanelToggle.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/exercise/ExerciseLesson.h"
#include "window/kinds/SuggestedName.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QMainWindow>
#include <QScopedValueRollback>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr int kTickMs = 500;
// Least pause between two checks during a gesture. The pause is also a multiple of the duration of the last check, so
// that checks take at most a fifth of the time, in part on the window's thread.
constexpr std::chrono::seconds kPause{2};
constexpr int kPauseOfCost = 4;
// Least working time, s, for which the user is asked to save work that is otherwise unchanged.
constexpr double kSecondsWorthAsking = 60.0;

const ExerciseKind& exerciseKind(const DocumentKinds& kinds) {
  return static_cast<const ExerciseKind&>(*kinds.withId("exercise"));
}

// Returns the title of the document of work on an exercise; empty: as for a document without a title.
QString titleOfWork(const ExerciseSnapshot& exercise) {
  const QString title = QString::fromStdString(inLanguage(exercise).title);
  if (title.isEmpty()) return {};
  const QString student =
      exercise.work && exercise.attempt ? QString::fromStdString(exercise.attempt->student) : QString();
  return student.isEmpty() ? RunningAttempt::tr("Work on %1").arg(title)
                           : RunningAttempt::tr("Work of %1 on %2").arg(student, title);
}

bool hasCheckedSteps(const Exercise& exercise) {
  const auto isChecked = [](const ExerciseStep& step) { return !step.criteria.empty(); };
  return std::any_of(exercise.steps.begin(), exercise.steps.end(), isChecked);
}

}  // namespace

RunningAttempt::RunningAttempt(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_lesson(new ExerciseLesson(parts.window)),
      m_checks(JobRunner::Policy::Latest, parts.pool) {
  m_lesson->setObjectName(QStringLiteral("exerciseLesson"));
  if (auto* window = qobject_cast<QMainWindow*>(parts.window)) {
    m_dock = new QDockWidget(tr("Lesson"), window);
    m_dock->setObjectName(QStringLiteral("lessonDock"));
    m_dock->setAccessibleName(tr("Lesson"));
    m_dock->setWidget(m_lesson);
    m_dock->setTitleBarWidget(new DockTitle(m_dock));
    window->addDockWidget(Qt::LeftDockWidgetArea, m_dock);
    m_dock->hide();
    m_toggle = new PanelToggle(m_dock, QStringLiteral("kind-exercise"));
    m_toggle->setToolTip(tr("Steps of the exercise, with the buttons to measure and to hand in the work"));
    m_toggle->setEnabled(false);
  }
  connect(&parts.tabs, &DocumentTabs::currentChanged, this, &RunningAttempt::follow);
  connect(&parts.tabs, &DocumentTabs::closing, this, &RunningAttempt::forget);
  connect(&m_clock, &QTimer::timeout, this, &RunningAttempt::tick);
  connectLesson();
}

void RunningAttempt::connectLesson() {
  connect(m_lesson, &ExerciseLesson::measuringRequested, this, &RunningAttempt::measure);
  connect(m_lesson, &ExerciseLesson::handInRequested, this, &RunningAttempt::handIn);
  connect(m_lesson, &ExerciseLesson::nameChanged, this, [this](const QString& student) {
    Work* const work = current();
    if (!work) return;
    work->attempt.student = student.toStdString();
    store(*work, true);
  });
  connect(m_lesson, &ExerciseLesson::hintTaken, this, [this](std::size_t step, std::size_t count) {
    Work* const work = current();
    if (!work) return;
    std::vector<std::size_t>& hints = work->attempt.hints;
    hints.resize(std::max(hints.size(), step + 1));
    hints[step] = std::max(hints[step], count);
    store(*work, true);
  });
  connect(m_lesson, &ExerciseLesson::stepDone, this, [this](std::size_t step) {
    Work* const work = current();
    if (!work) return;
    setDone(*work, step, true);
    store(*work, true);
  });
}

RunningAttempt::Work* RunningAttempt::find(const DocumentTab* tab) {
  const auto found = std::find_if(m_works.begin(), m_works.end(), [&](const Work& each) { return each.tab == tab; });
  return found == m_works.end() ? nullptr : &*found;
}

const DocumentTab* RunningAttempt::workOn(const DocumentTab& from) const {
  const std::string& key = static_cast<const ExerciseDocument&>(from.document).exercise().key;
  const DocumentTab* any = nullptr;
  for (auto each = m_works.rbegin(); each != m_works.rend(); ++each) {
    if (each->exercise->key != key) continue;
    if (isBegunFrom(each->tab->document.file().assigned, from.document.file())) return each->tab;
    if (!any) any = each->tab;
  }
  return any;
}

// The submission of another student is other work, even on the same exercise, and so is the copy that a teacher tries;
// a teacher who has changed the exercise begins anew. file: file of the exercise.
RunningAttempt::Work* RunningAttempt::begunFrom(const std::shared_ptr<const ExerciseSnapshot>& exercise,
                                                const DocumentFile& file, const AssignedExercise& assigned) {
  const auto isOfThis = [&](const Work& each) { return each.origin == exercise; };
  const auto isAlike = [&](const Work& each) {
    const AssignedExercise& work = each.tab->document.file().assigned;
    return !exercise->work && isSameExercise(work, assigned) && isBegunFrom(work, file);
  };
  // Exercises that were never saved have no id to tell their works apart.
  auto found = std::find_if(m_works.rbegin(), m_works.rend(), isOfThis);
  if (found == m_works.rend()) found = std::find_if(m_works.rbegin(), m_works.rend(), isAlike);
  return found == m_works.rend() ? nullptr : &*found;
}

void RunningAttempt::begin(const DocumentTab& from) {
  const auto exercise = std::static_pointer_cast<const ExerciseSnapshot>(from.document.snapshot());
  Attempt attempt = exercise->attempt.value_or(Attempt());
  attempt.handedIn.clear();
  if (attempt.begun.empty()) attempt.begun = presentTime();
  const DocumentFile& file = from.document.file();
  const AssignedExercise assigned = assignmentOf(*exercise, attempt, file.id);
  m_isDockWanted = true;
  if (const Work* const work = begunFrom(exercise, file, assigned)) return m_parts.tabs.setCurrent(work->tab);

  const DocumentKind* kind = m_parts.kinds.withId(exercise->subject->kind().id());
  OpenedFile opened{kind, {}, {}};
  opened.file.id = newDocumentId();
  opened.file.title = titleOfWork(*exercise).toStdString();
  opened.file.assigned = assigned;
  if (exercise->work) opened.file.recordings = file.recordings;
  opened.content = exercise->work;
  if (!opened.content && exercise->subject->startsSlowly()) return prepare(from, exercise, std::move(opened));
  if (!opened.content) opened.content = exercise->subject->start(*exercise->task);
  start(exercise, std::move(opened));
}

// A second click while it is prepared begins the same work.
void RunningAttempt::prepare(const DocumentTab& from, const std::shared_ptr<const ExerciseSnapshot>& exercise,
                             OpenedFile work) {
  Job job;
  job.name = tr("Preparing the exercise");
  job.document = &from.document;
  job.lane = Job::Lane::Looking;
  job.outlivesDocument = true;
  job.work = [this, exercise, file = from.document.file(), work](Progress) mutable {
    work.content = exercise->subject->start(*exercise->task);
    return Job::Finish([this, exercise, file, work]() mutable {
      if (const Work* const begun = begunFrom(exercise, file, work.file.assigned))
        return m_parts.tabs.setCurrent(begun->tab);
      start(exercise, std::move(work));
    });
  };
  m_parts.jobs.start(std::move(job));
}

void RunningAttempt::start(const std::shared_ptr<const ExerciseSnapshot>& exercise, OpenedFile work) {
  const QScopedValueRollback beginning(m_beginning, begunCopy(*exercise, work.file.assigned));
  const QScopedValueRollback as(m_beginningAs, work.file.assigned.description);
  DocumentTab* const tab = m_parts.openDocument(std::move(work));
  follow(tab);
  if (Work* const begun = find(tab)) begun->origin = exercise;
  emit changed();
  // By then the window has raised the panel of the new document, and the lesson has its instructions.
  QTimer::singleShot(0, this, [this] { showDock(m_isCurrent && m_isDockWanted); });
}

// Takes the exercise that a document is work on, which is read unless it is at hand. False: it is none, or one that
// cannot be read.
bool RunningAttempt::take(DocumentTab* tab) {
  const AssignedExercise& assigned = tab->document.file().assigned;
  if (!assigned) return false;
  Result<std::shared_ptr<const ExerciseSnapshot>> exercise = m_beginning && assigned.description == m_beginningAs
                                                                 ? m_beginning
                                                                 : exerciseOf(exerciseKind(m_parts.kinds), assigned);
  if (!exercise || (*exercise)->subject->kind().id() != tab->document.kind().id()) {
    const QString title = tr("The exercise that %1 belongs to cannot be read").arg(tab->document.name());
    fail(title, exercise ? Error{ErrorCode::ElementMalformed, {"exercise", "it is of another kind"}, {}, {}}
                         : exercise.error());
    return false;
  }
  const Attempt attempt = (*exercise)->attempt.value_or(Attempt());
  m_works.push_back({tab, std::move(*exercise), attempt, nullptr, attempt.seconds});
  emit changed();
  return true;
}

void RunningAttempt::follow(DocumentTab* tab) {
  if (m_isCurrent && m_works.back().tab == tab) return;
  if (m_clock.isActive()) tick();
  m_clock.stop();
  if (m_isCurrent && m_dock) m_isDockWanted = !m_dock->isHidden();
  m_isCurrent = tab && (find(tab) || take(tab));
  disconnect(m_changes);
  disconnect(m_records);
  if (m_isCurrent) {
    m_changes = connect(&tab->document, &Document::changed, this, &RunningAttempt::check);
    m_records = connect(&tab->document, &Document::fileChanged, this, &RunningAttempt::recorded);
    find(tab)->see();
    const auto position = m_works.begin() + (find(tab) - m_works.data());
    std::rotate(position, position + 1, m_works.end());
    show(m_works.back());
    m_since.start();
    m_clock.start(kTickMs);
  }
  showDock(m_isCurrent && m_isDockWanted);
  if (m_toggle) m_toggle->setEnabled(m_isCurrent);
}

// Also shows the last measured sizes, which may be outdated.
void RunningAttempt::show(const Work& work) {
  m_lesson->setExercise(*work.exercise, work.attempt, true);
  if (!work.sizes) return;
  m_lesson->setMeasured(*work.exercise, *work.sizes);
  if (work.areSizesOld) m_lesson->setOutdated();
}

void RunningAttempt::forget(DocumentTab* tab) {
  Work* const work = find(tab);
  if (!work) return;
  m_checks.forget(&tab->document);
  if (work == current()) {
    m_clock.stop();
    m_isCurrent = false;
    showDock(false);
    if (m_toggle) m_toggle->setEnabled(false);
  }
  m_works.erase(m_works.begin() + (work - m_works.data()));
  emit changed();
}

void RunningAttempt::showDock(bool isShown) {
  if (!m_dock) return;
  m_dock->setVisible(isShown);
  if (isShown) m_dock->raise();
}

// isChange: that it is not in the file yet is worth a question before it is closed.
void RunningAttempt::store(Work& work, bool isChange) {
  if (isChange) work.secondsInFile = work.attempt.seconds;
  const QScopedValueRollback storing(m_isStoring, true);
  work.tab->document.assign(withAttempt(work.tab->document.file().assigned, work.attempt), isChange);
  work.revision = work.tab->document.revision();
}

void RunningAttempt::Work::see() {
  revision = tab->document.revision();
  seen = tab->document.snapshot();
}

void RunningAttempt::setDone(Work& work, std::size_t step, bool isDone) {
  work.attempt.done.resize(std::max(work.attempt.done.size(), step + 1));
  work.attempt.done[step] = isDone;
}

void RunningAttempt::tick() {
  Work* const work = current();
  if (!work) return;
  const double seconds = work->attempt.seconds + static_cast<double>(m_since.restart()) / 1000.0;
  work->attempt.seconds = std::min(seconds, Exercise::kLongestTime);
  store(*work, work->attempt.seconds - work->secondsInFile >= kSecondsWorthAsking);
  m_lesson->setSeconds(work->attempt.seconds, work->exercise->exercise.allowedSeconds);
  followGesture(*work);
}

// A pass of several minutes makes and spoils sizes before it is in the document.
void RunningAttempt::followGesture(Work& work) {
  if (!m_parts.tools.isUnderWay(work.tab->document)) {
    if (work.isUnderWay) check();  // it was given up
    return;
  }
  if (!std::exchange(work.isUnderWay, true)) outdate(work);
  if (!m_checks.isBusyWith(&work.tab->document) && Clock::now() >= work.nextCheck) checkSteps(work);
}

// Measures the sizes of the drawing too, as the student requested.
void RunningAttempt::measure() {
  Work* const measured = current();
  if (!measured) return;
  measured->tab->document.settle();
  startMeasuring(*measured);
}

void RunningAttempt::startMeasuring(Work& measured) {
  start(m_parts.jobs, tr("Measuring"), measured, true);
}

void RunningAttempt::outdate(Work& work) {
  ++work.changes;
  work.areSizesOld = true;
  if (&work == current()) m_lesson->setOutdated();
}

// Returns the value of the document, including an unfinished gesture.
SnapshotPointer RunningAttempt::now(Work& work) {
  const Document& document = work.tab->document;
  const std::uint64_t before = document.revision();
  const QScopedValueRollback recording(m_isStoring, true);
  SnapshotPointer value = m_parts.tools.valueWithGesture(document);
  if (!value) value = document.snapshot();
  if (document.revision() != before) {  // a crash was recorded, which is in the value
    outdate(work);
    work.see();
  }
  return value;
}

// Ticks steps as soon as their criteria are met; sizes are only shown on request. The tool may be in the middle of the
// call that changed the document, so its gesture is queried afterwards.
void RunningAttempt::check() {
  Work* const changed = current();
  if (!changed) return;
  outdate(*changed);
  changed->see();
  if (std::exchange(changed->isCheckDue, true)) return;
  QTimer::singleShot(0, this, [this, tab = changed->tab] {
    Work* const work = find(tab);
    if (!work) return;
    work->isCheckDue = false;
    work->isUnderWay = m_parts.tools.isUnderWay(tab->document);
    if (!work->isUnderWay) checkSteps(*work);  // else followGesture() does, at its pace
  });
}

// Crashes and other records without an undo step have marks, too. Changes outside of the value, such as the name of the
// file, have none.
void RunningAttempt::recorded() {
  const Work* const work = current();
  if (!work || m_isStoring || work->tab->document.revision() == work->revision) return;
  if (work->seen.lock() != work->tab->document.snapshot()) check();
}

void RunningAttempt::checkSteps(Work& checked) {
  if (!hasCheckedSteps(checked.exercise->exercise)) return;
  checked.nextCheck = Clock::now() + kPause;
  start(m_checks, tr("Checking the steps"), checked, false);
}

void RunningAttempt::start(JobRunner& jobs, const QString& name, Work& measured, bool showsSizes) {
  const Clock::time_point asked = Clock::now();
  SnapshotPointer value = now(measured);
  const Clock::duration taking = Clock::now() - asked;
  Job job;
  job.name = name;
  job.document = &measured.tab->document;
  job.lane = Job::Lane::Looking;
  job.isUnasked = !showsSizes;
  job.work = [this, showsSizes, taking, tab = measured.tab, exercise = measured.exercise, changes = measured.changes,
              work = std::move(value), attempt = measured.attempt](Progress progress) -> Job::Finish {
    const Clock::time_point begun = Clock::now();
    auto marking = std::make_shared<const Marking>(markWork(*exercise, *work, attempt, progress));
    if (progress.cancelled()) return {};
    const Clock::duration cost = taking + (Clock::now() - begun);
    return [this, showsSizes, tab, exercise, changes, marking, cost] {
      Work* const found = find(tab);
      if (!found) return;
      if (!showsSizes) found->nextCheck = Clock::now() + std::max<Clock::duration>(kPause, kPauseOfCost * cost);
      // The part has changed: that change has restarted the checks, and the requested measurement is restarted here.
      if (found->changes != changes) return showsSizes ? startMeasuring(*found) : void();
      take(tab, *exercise, marking, showsSizes);
    };
  };
  jobs.start(std::move(job));
}

void RunningAttempt::take(const DocumentTab* tab, const ExerciseSnapshot& exercise,
                          const std::shared_ptr<const Marking>& marking, bool showsSizes) {
  Work* const work = find(tab);
  if (!work) return;
  const std::vector<bool> before = work->attempt.done;
  for (std::size_t i = 0; i < exercise.exercise.steps.size(); ++i) {
    const ExerciseStep& step = exercise.exercise.steps[i];
    if (!step.criteria.empty()) setDone(*work, i, isMet(step, *marking));
  }
  if (showsSizes) {
    work->sizes = marking;
    work->areSizesOld = m_parts.tools.isUnderWay(work->tab->document);  // it goes on
  }
  if (showsSizes || work->attempt.done != before) store(*work, true);
  if (work != current()) return;
  m_lesson->setMet(exercise, *marking);
  if (!showsSizes) return;
  m_lesson->setMeasured(exercise, *marking);
  if (work->areSizesOld) m_lesson->setOutdated();
}

void RunningAttempt::fail(const QString& title, const Error& error) {
  emit message({Message::Weight::Error, title, errorSentence(error), errorAdvice(error)});
}

}  // namespace handwheel
