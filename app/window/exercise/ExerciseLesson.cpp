// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/ExerciseLesson.h"

#include "panels/LessonPanel.h"
#include "text/NoteText.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

namespace {

QLabel* wrapped(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QString joinedHints(const ExerciseStep& step) {
  QStringList hints;
  for (const std::string& hint : step.hints) hints += QString::fromStdString(hint);
  return hints.join(QLatin1Char('\n'));
}

// "✓ ⌀30 h10: 29.95 mm is within 29.916 and 30 mm", one line for each criterion on the drawing.
QString measuredText(const Exercise& exercise, const Marking& marking) {
  QStringList lines;
  for (const Mark& mark : marking.marks) {
    const MarkingCriterion* c = exercise.find(mark.criterion);
    if (!c || c->isHidden) continue;
    const QString sign = mark.verdict == Verdict::Met ? QStringLiteral("✓") : QStringLiteral("✗");
    lines += sign + QLatin1Char(' ') + QString::fromStdString(c->name) + QStringLiteral(": ") +
             noteText({mark.reason.text, mark.reason.arguments});
  }
  return lines.join(QLatin1Char('\n'));
}

}  // namespace

bool isMet(const ExerciseStep& step, const Marking& marking) {
  return !step.criteria.empty() && std::all_of(step.criteria.begin(), step.criteria.end(), [&](const std::string& id) {
    const Mark* mark = marking.find(id);
    return mark && mark->verdict == Verdict::Met;
  });
}

ExerciseLesson::ExerciseLesson(QWidget* parent)
    : QWidget(parent),
      m_text(wrapped(this)),
      m_begin(new QPushButton(tr("&Begin"), this)),
      m_steps(new LessonPanel(this)),
      m_measured(wrapped(this)),
      m_measure(new QPushButton(tr("&Measure"), this)),
      m_name(new QLineEdit(this)),
      m_handIn(new QPushButton(tr("&Hand in…"), this)) {
  m_begin->setObjectName(QStringLiteral("lesson/begin"));
  m_measure->setObjectName(QStringLiteral("lesson/measure"));
  m_measure->setToolTip(tr("Measure the sizes of the drawing on the part as it is now"));
  m_measured->setObjectName(QStringLiteral("lesson/measured"));
  m_name->setObjectName(QStringLiteral("lesson/name"));
  m_name->setPlaceholderText(tr("Your name"));
  m_name->setAccessibleName(tr("Your name"));
  m_handIn->setObjectName(QStringLiteral("lesson/handIn"));
  auto* column = new QVBoxLayout(this);
  column->addWidget(m_text);
  column->addWidget(m_begin);
  column->addWidget(m_steps, 1);
  for (QWidget* each : std::initializer_list<QWidget*>{m_measure, m_measured, m_name, m_handIn})
    column->addWidget(each);
  connect(m_begin, &QPushButton::clicked, this, &ExerciseLesson::begun);
  connect(m_measure, &QPushButton::clicked, this, &ExerciseLesson::measuringRequested);
  connect(m_name, &QLineEdit::textChanged, this, &ExerciseLesson::followName);
  connect(m_handIn, &QPushButton::clicked, this, [this] { emit handInRequested(m_name->text().trimmed()); });
  connect(m_steps, &LessonPanel::hintShown, this,
          [this](int step) { emit hintsTaken(static_cast<std::size_t>(step)); });
  connect(m_steps, &LessonPanel::stepDone, this, [this](int step) {
    m_steps->setStepState(static_cast<std::size_t>(step), LessonStep::State::Done);
    emit stepDone(static_cast<std::size_t>(step));
  });
}

void ExerciseLesson::setExercise(const Exercise& exercise, const Attempt& attempt, bool isRunning) {
  m_isRunning = isRunning;
  m_text->setText(QString::fromStdString(exercise.text));
  std::vector<LessonStep> steps;
  for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
    const ExerciseStep& each = exercise.steps[i];
    const bool isDone = i < attempt.done.size() && attempt.done[i];
    steps.push_back({QString::fromStdString(each.title), QString::fromStdString(each.text), joinedHints(each),
                     isDone ? LessonStep::State::Done : LessonStep::State::Open, each.criteria.empty()});
  }
  m_steps->setLesson(QString::fromStdString(exercise.title), std::move(steps));
  m_begin->setVisible(!isRunning);
  m_steps->setEnabled(isRunning);
  for (QWidget* each : std::initializer_list<QWidget*>{m_measure, m_measured, m_name, m_handIn})
    each->setVisible(isRunning);
  m_measured->clear();
  setSeconds(attempt.seconds, exercise.allowedSeconds);
  followName();
}

void ExerciseLesson::setSeconds(double seconds, double allowed) {
  m_steps->setTime(seconds, allowed);
}

void ExerciseLesson::setMeasured(const Exercise& exercise, const Marking& marking) {
  m_measured->setText(measuredText(exercise, marking));
  for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
    if (exercise.steps[i].criteria.empty()) continue;
    m_steps->setStepState(i, isMet(exercise.steps[i], marking) ? LessonStep::State::Done : LessonStep::State::Open);
  }
}

void ExerciseLesson::followName() {
  m_handIn->setEnabled(m_isRunning && !m_name->text().trimmed().isEmpty());
}

}  // namespace handwheel
