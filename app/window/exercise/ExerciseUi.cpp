// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The pages and the exercise itself. Its target: ExerciseUiTarget.cpp; marking of a class: ExerciseUiMarking.cpp.
#include "window/exercise/ExerciseUi.h"

#include "document/exercise/ExerciseKind.h"
#include "document/exercise/ShippedExercises.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "theme/Icons.h"
#include "theme/Theme.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/exercise/ExerciseEditor.h"
#include "window/exercise/ExerciseLesson.h"
#include "window/exercise/RunningAttempt.h"
#include "window/exercise/SubmissionsView.h"
#include "window/kinds/KindPanel.h"
#include "window/kinds/SuggestedName.h"

#include <QCoreApplication>
#include <QFile>
#include <QLocale>
#include <QStackedWidget>

namespace handwheel {

namespace {

// The command that begins an exercise about a subject.
QString newExercise(const ExerciseSubject& subject) {
  return QStringLiteral("newExercise/") + QString::fromStdString(subject.id());
}

}  // namespace

ExerciseUi::ExerciseUi(const WindowContext& window)
    : RigidPartsUi(window, {}, StandardView::Lathe),
      m_pages(new QStackedWidget(window.window)),
      m_editor(new ExerciseEditor(m_pages)),
      m_student(new ExerciseLesson(m_pages)),
      m_attempt(new RunningAttempt(window, this)) {
  RigidPartsUi::panel()->hide();  // the pages replace it
  m_student->setObjectName(QStringLiteral("exercisePage"));
  m_pages->addWidget(m_editor);
  m_pages->addWidget(m_student);
  buildActions();
  m_editor->showTargetActions({m_import, m_target, m_turn, m_round});
  connect(m_attempt, &RunningAttempt::message, this, &KindUi::message);
  connect(m_attempt, &RunningAttempt::changed, this, &ExerciseUi::refresh);
  connect(m_student, &ExerciseLesson::begun, m_begin, &QAction::trigger);
  SubmissionsView* const table = m_editor->classView();
  connect(table, &SubmissionsView::markingRequested, m_mark, &QAction::trigger);
  connect(table, &SubmissionsView::reportRequested, this, [this] { writeClass(ClassFile::Report); });
  connect(table, &SubmissionsView::tableRequested, this, [this] { writeClass(ClassFile::Table); });
  connect(table, &SubmissionsView::comparisonRequested, this, [this] { writeClass(ClassFile::Comparison); });
  connect(table, &SubmissionsView::openRequested, this, [this](std::size_t work) {
    if (m_shownClass && work < m_shownClass->size())
      parts().openFile(QFile::decodeName(QByteArray::fromStdString((*m_shownClass)[work]->path)));
  });
  connect(table, &SubmissionsView::removalRequested, this, &ExerciseUi::removeWorks);
  refresh();
}

void ExerciseUi::buildActions() {
  const auto action = [this](const char* name, const QString& text, const QString& tip) {
    auto* made = new QAction(text, this);
    made->setObjectName(QString::fromLatin1(name));
    setActionToolTip(*made, tip);
    return made;
  };
  m_begin = action("beginExercise", tr("&Begin"), tr("Open the stock and work on the exercise, step by step"));
  m_preview =
      action("studentCopy", tr("&Student's copy"), tr("Open the exercise as students see it; save it for them"));
  m_solution = action("takeSolution", tr("Take as model s&olution"),
                      tr("Keep the work that was started from this exercise as its model solution"));
  m_openSolution = action("openSolution", tr("Op&en the model solution"),
                          tr("Open a copy of the model solution, to look at it or to go on from it"));
  m_import = action("importExerciseTarget", tr("&Import target…"),
                    tr("Import the shape that students are to make, from DXF, SVG, STEP, a mesh or a workpiece"));
  m_target = action("takeTarget", tr("Take as &target"), tr("Make the shape of that work the target of the exercise"));
  m_turn = action("turnTargetAction", tr("Turn the target en&d for end"),
                  tr("Make the end at the chuck the free one, whose face is finished"));
  m_round = action("roundTargetAction", tr("&Round the target…"),
                   tr("Give the target round sizes and sharp corners, as a drawing has them"));
  m_mark = action("markExercise", tr("&Mark…"), tr("Mark files that students have handed in"));
  connect(m_begin, &QAction::triggered, this, [this] { m_attempt->begin(*document()); });
  connect(m_preview, &QAction::triggered, this, &ExerciseUi::openStudentCopy);
  connect(m_solution, &QAction::triggered, this, [this] { takeWork(false); });
  connect(m_openSolution, &QAction::triggered, this, &ExerciseUi::openSolution);
  connect(m_import, &QAction::triggered, this, &ExerciseUi::askForTarget);
  connect(m_target, &QAction::triggered, this, [this] { takeWork(true); });
  connect(m_turn, &QAction::triggered, this, &ExerciseUi::turnTarget);
  connect(m_round, &QAction::triggered, this, &ExerciseUi::askToRound);
  connect(m_mark, &QAction::triggered, this, &ExerciseUi::chooseSubmissions);
}

ExerciseDocument* ExerciseUi::current() const {
  return document() ? static_cast<ExerciseDocument*>(&document()->document) : nullptr;
}

std::shared_ptr<const ExerciseSnapshot> ExerciseUi::snapshot() const {
  return std::static_pointer_cast<const ExerciseSnapshot>(current()->snapshot());
}

void ExerciseUi::setDocument(DocumentTab* document) {
  // Without its pages an exercise is only a picture, and the visibility of panels belongs to the previous document.
  if (document && document != this->document()) showKindPanel(parts());
  RigidPartsUi::setDocument(document);
  if (current() != nullptr) connect(current(), &Document::changed, this, &ExerciseUi::refresh);
  m_editor->setDocument(current() && !current()->exercise().isForStudents ? current() : nullptr);
  refresh();
}

// A change of the title does not change the shape. Work that takes long to prepare is not shown here: its task is shown
// instead, and Begin opens it.
DisplayModel ExerciseUi::displayed(const Document& document) const {
  const ExerciseSnapshot& exercise = static_cast<const ExerciseDocument&>(document).exercise();
  if (m_displayedTask != exercise.task || m_displayedWork != exercise.work) {
    m_displayed = exercise.subject->startsSlowly() ? exercise.subject->display(*exercise.task)
                                                   : RigidPartsUi::displayed(document);
    m_displayedTask = exercise.task;
    m_displayedWork = exercise.work;
  }
  return m_displayed;
}

bool ExerciseUi::isOfLathe() const {
  return current() && current()->exercise().subject->isTurned();
}

void ExerciseUi::refresh() {
  for (QAction* action : menu()) offer(*action, false, tr("Open an exercise first."));
  if (!current()) return;
  offer(*m_begin, true, {});
  const ExerciseSnapshot& exercise = current()->exercise();
  const bool isStudent = exercise.isForStudents;
  m_pages->setCurrentWidget(isStudent ? static_cast<QWidget*>(m_student) : m_editor);
  showClass();
  if (isStudent) m_student->setExercise(exercise, exercise.attempt.value_or(Attempt()), false);
  const bool hasWork = m_attempt->workOn(*document()) != nullptr;
  const auto offerTeacher = [&](QAction& action, bool isThere = true, const QString& reason = {}) {
    offer(action, !isStudent && isThere, isStudent ? tr("This is a student's copy.") : reason);
  };
  const QString noWork = tr("No work on this exercise is open.");
  offerTeacher(*m_preview);
  offerTeacher(*m_mark);
  offerTeacher(*m_solution, hasWork, noWork);
  offerTeacher(*m_openSolution, exercise.solution != nullptr, tr("The exercise has no solution."));
  offerTeacher(*m_import);
  offerTeacher(*m_target, hasWork, noWork);
  const bool hasTarget = exercise.subject->endsNote(*exercise.task).has_value();
  for (QAction* const change : {m_turn, m_round})
    offerTeacher(*change, hasTarget,
                 isOfLathe() ? tr("The exercise has no target.") : tr("It is for targets of turned parts only."));
  emit stateChanged();
}

QWidget* ExerciseUi::panel() {
  return m_pages;
}

QList<QAction*> ExerciseUi::menu() {
  return {m_begin, m_preview, m_solution, m_openSolution, m_import, m_target, m_turn, m_round, m_mark};
}

QList<QAction*> ExerciseUi::toolBar() {
  return {m_begin, m_preview, m_mark};
}

void ExerciseUi::begin(const QString& startAction) {
  const auto& kind = static_cast<const ExerciseKind&>(*parts().kinds.withId("exercise"));
  for (const auto& subject : kind.subjects()) {
    if (startAction != newExercise(*subject)) continue;
    OpenedFile opened{&kind, {}, kind.blankOf(*subject)};
    opened.file.id = newDocumentId();
    parts().openDocument(std::move(opened));
  }
}

std::vector<StartAction> ExerciseUi::startActions() const {
  std::vector<StartAction> all = {
      {QStringLiteral("newExercise"), tr("New e&xercise"), tr("Prepare an exercise for students"), panelIcon()},
      {QStringLiteral("openFirstLesson"), tr("First &lesson at the lathe"),
       tr("Turn a shoulder step by step; no experience is needed"), panelIcon(),
       QStringLiteral("first-lesson.exercise.json"),
       StartTile{QStringLiteral("lessonTile"), panelIcon(), tr("Turn your first shoulder"),
                 tr("A lesson of about five minutes: the program says what to do, and measures the part.")}}};
  // The first subject is that of “New exercise”.
  const auto& kind = static_cast<const ExerciseKind&>(*parts().kinds.withId("exercise"));
  for (const auto& subject : kind.subjects().subspan(1))
    all.insert(all.begin() + 1,
               {newExercise(*subject),
                tr("New exercise: %1").arg(QCoreApplication::translate("Figure", subject->title().c_str())),
                tr("Prepare an exercise for students"),
                panelIcon(),
                {},
                {},
                true});
  const std::pair<const char*, QString> shipped[] = {{"shaft", tr("Exercise: shaft with shoulders")},
                                                     {"bush", tr("Exercise: bored bush")},
                                                     {"thread-m20", tr("Exercise: thread M20")},
                                                     {"ball", tr("Exercise: ball")},
                                                     {"gourd", tr("Exercise: gourd")},
                                                     {"dumb-bell", tr("Exercise: dumb-bell weight")},
                                                     {"wine-glass", tr("Exercise: wine glass")},
                                                     {"first-lesson-teacher", tr("Exercise: first shoulder")},
                                                     {"skull", tr("Exercise: burr hole in the skull")}};
  for (const auto& [name, text] : shipped) {
    const QString id = QString::fromLatin1(name);
    all.push_back({QStringLiteral("exercise/") + id, text, tr("Open a prepared exercise"), panelIcon(),
                   id + QStringLiteral(".exercise.json")});
  }
  all.back().tile = StartTile{QStringLiteral("burrHoleTile"), QStringLiteral("drill"), tr("Drill a burr hole"),
                              tr("Opens an exercise on a skull: drill along the rod, and stop at the breakthrough.")};
  return all;
}

Suggestion ExerciseUi::suggestion() {
  if (!current()) return {};
  const ExerciseSnapshot& exercise = current()->exercise();
  const QColor accent = themeColours(currentTheme()).accent;
  const QString title = QString::fromStdString(inLanguage(exercise).title);
  if (exercise.attempt && exercise.attempt->isHandedIn())
    return {panelIcon(),
            accent,
            tr("Handed in by %1").arg(QString::fromStdString(exercise.attempt->student)),
            tr("The teacher marks it with the exercise."),
            {}};
  if (exercise.isForStudents)
    return {panelIcon(),
            accent,
            title,
            tr("%n step(s)", nullptr, static_cast<int>(exercise.exercise.steps.size())),
            {m_begin}};
  return {
      panelIcon(),
      accent,
      title.isEmpty() ? tr("New exercise") : title,
      tr("Points: %1. Students get a copy without the answers.").arg(QLocale().toString(exercise.exercise.points())),
      {m_begin, m_preview}};
}

QString ExerciseUi::openedText(const DocumentTab& opened) const {
  const ExerciseSnapshot& exercise = static_cast<const ExerciseDocument&>(opened.document).exercise();
  return tr("Opened %1: exercise “%2”").arg(opened.document.name(), QString::fromStdString(inLanguage(exercise).title));
}

QString ExerciseUi::suggestedName(const DocumentTab& document) const {
  const ExerciseSnapshot& exercise = static_cast<const ExerciseDocument&>(document.document).exercise();
  const QString title = QString::fromStdString(inLanguage(exercise).title);
  if (title.isEmpty() || !document.document.path().isEmpty()) return KindUi::suggestedName(document);
  return fileNameOf(exercise.isForStudents ? QStringList{title, tr("student's copy")} : QStringList{title},
                    QStringLiteral("handwheel"));
}

// Called other than the exercise, so that neither its tab nor its file is taken for that.
void ExerciseUi::openStudentCopy() {
  const ExerciseSnapshot content = forStudents(*snapshot());
  OpenedFile opened = DocumentKinds::blank(current()->kind());
  const QString title = QString::fromStdString(inLanguage(content).title);
  opened.file.title = (title.isEmpty() ? tr("Student's copy") : tr("%1, student's copy").arg(title)).toStdString();
  opened.content = std::make_shared<const ExerciseSnapshot>(content);
  parts().openDocument(std::move(opened));
}

void ExerciseUi::report(const QString& title, const Error& error) {
  emit message({Message::Weight::Error, title, errorSentence(error), errorAdvice(error)});
}

void ExerciseUi::takeWork(bool asTarget) {
  const DocumentTab* const from = current() ? m_attempt->workOn(*document()) : nullptr;
  if (!from) return;
  const SnapshotPointer work = from->document.snapshot();
  ExerciseSnapshot changed = current()->exercise();
  if (const Status fits = changed.subject->checkWork(*changed.task, *work); !fits)
    return report(asTarget ? tr("The target was not taken") : tr("The model solution was not taken"), fits.error());
  if (asTarget) return takeTarget(work);
  changed.solution = work;
  const auto steps = static_cast<int>(from->document.history()->index());
  current()->change(tr("Take the model solution"), std::move(changed));
  emit message(
      {Message::Weight::Info, tr("Model solution taken"),
       tr("The work in “%1”, as it is after %n step(s) of its history, is the model solution now.", nullptr, steps)
           .arg(from->document.name()),
       tr("“Open the model solution” shows it. Students do not get it.")});
}

// Opens another document: changes there do not change the exercise.
void ExerciseUi::openSolution() {
  const ExerciseSnapshot& exercise = current()->exercise();
  const DocumentKind* kind = parts().kinds.withId(exercise.subject->kind().id());
  OpenedFile opened = DocumentKinds::blank(*kind);
  const QString title = QString::fromStdString(inLanguage(exercise).title);
  opened.file.title = (title.isEmpty() ? tr("Model solution") : tr("Model solution of %1").arg(title)).toStdString();
  opened.content = exercise.solution;
  parts().openDocument(std::move(opened));
}

}  // namespace handwheel
