// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/ExerciseLesson.h"

#include "controls/ScrolledPanel.h"
#include "document/exercise/ShippedExercises.h"
#include "panels/LessonPanel.h"
#include "window/exercise/ReasonText.h"

#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

QLabel* wrapped(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setTextFormat(Qt::PlainText);  // exercises come from anywhere
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

LessonStep lessonStep(const Exercise& exercise, const Attempt& attempt, std::size_t i) {
  const ExerciseStep& step = exercise.steps[i];
  LessonStep shown{QString::fromStdString(step.title), QString::fromStdString(step.text)};
  for (const std::string& hint : step.hints) shown.hints += QString::fromStdString(hint);
  shown.shownHints = i < attempt.hints.size() ? static_cast<int>(attempt.hints[i]) : 0;
  if (i < attempt.done.size() && attempt.done[i]) shown.state = LessonStep::State::Done;
  shown.byHand = step.criteria.empty();
  return shown;
}

// "-30": a coordinate in mm.
QString coordinateText(double at) {
  constexpr double kShown = 1e6;  // steps per mm; smaller differences are rounding
  return QLocale().toString(std::round(at * kShown) / kShown + 0.0, 'g', 8);
}

// Returns the positions at which a criterion is measured: the faces of a length by their heights, else each position
// with its name. zero: zero of the read-out in Z.
QString measuredAtText(const MarkingCriterion& c, const MeasurementType& type, double zero) {
  QStringList positions, heights;
  for (std::size_t i = 0; i < std::min(type.arguments.size(), c.arguments.size()); ++i) {
    const bool isHeight = type.arguments[i].ends_with('Z');
    const QString at = coordinateText(c.arguments[i] - (isHeight ? zero : 0.0));
    if (isHeight) heights << at;
    positions << QCoreApplication::translate("Property", type.arguments[i].c_str()) + QLatin1Char(' ') + at +
                     QStringLiteral(" mm");
  }
  const bool areFaces = heights.size() == 2 && positions.size() == 4;  // with the radius at which each is
  return areFaces ? ExerciseLesson::tr("between the faces at Z %1 mm and Z %2 mm").arg(heights[0], heights[1])
                  : positions.join(QStringLiteral(", "));
}

// "⌀30 ±0.15" does not say "±0.1".
bool saysTolerance(const QString& name, const QString& tolerance) {
  for (qsizetype at = name.indexOf(tolerance); at >= 0; at = name.indexOf(tolerance, at + 1)) {
    const qsizetype end = at + tolerance.size();
    if (end == name.size() || !name[end].isLetterOrNumber()) return true;
  }
  return false;
}

// "⌀30", and "h10" behind it where the name does not say that already; of "6g pitch diameter" the class alone.
QString nameWithTolerance(const MarkingCriterion& c) {
  const QString name = QString::fromStdString(c.name);
  const QString tolerance = QString::fromStdString(c.tolerance).section(QLatin1Char(' '), 0, 0);
  return tolerance.isEmpty() || saysTolerance(name, tolerance) ? name : name + QLatin1Char(' ') + tolerance;
}

// "⌀30 h10: 29.916 … 30 mm", and where it is measured.
QString sizeText(const MarkingCriterion& c, const MeasurementType& type, double zero) {
  constexpr double kShownOfDegree = 100.0;  // parts
  const bool isTime = type.unit == "s";
  const auto value = [&](double figure) {
    if (type.unit == "°") figure = std::round(figure * kShownOfDegree) / kShownOfDegree;
    return isTime ? QString::fromStdString(minutesText(figure)) : QLocale().toString(figure, 'g', 8);
  };
  const QString unit = type.unit.empty() || isTime ? QString() : QLatin1Char(' ') + QString::fromStdString(type.unit);
  QString text = nameWithTolerance(c);
  if (c.lower && c.upper)
    text += ExerciseLesson::tr(": %1 … %2%3").arg(value(*c.lower), value(*c.upper), unit);
  else if (c.upper)
    text += ExerciseLesson::tr(": at most %1%2").arg(value(*c.upper), unit);
  else if (c.lower)
    text += ExerciseLesson::tr(": at least %1%2").arg(value(*c.lower), unit);
  const QString position = measuredAtText(c, type, zero);
  return position.isEmpty() ? text : text + QStringLiteral("\n    ") + position;
}

// Returns the data of the drawing: stock and machine, then each size with its limits.
QString drawingText(const ExerciseSnapshot& shown, const Exercise& exercise) {
  QStringList lines;
  for (const ExerciseText& line : shown.subject->conditions(*shown.task)) lines += exerciseText(line);
  lines += QString();
  const std::vector<MeasurementType> types = measurementTypes(*shown.subject);
  const double zero = shown.subject->drawingZero(*shown.task).value_or(0.0);
  for (const MarkingCriterion& c : exercise.criteria) {
    const MeasurementType* type = measurementType(types, c.figure);
    if (type && !c.isHidden) lines += QStringLiteral("• ") + sizeText(c, *type, zero);
  }
  return lines.join(QLatin1Char('\n'));
}

// "✓ ⌀30 h10: 29.95 mm is within 29.916 and 30 mm", one line for each criterion on the drawing.
QString measuredText(const Exercise& exercise, const Marking& marking) {
  QStringList lines;
  for (const Mark& mark : marking.marks) {
    const MarkingCriterion* c = exercise.find(mark.criterion);
    if (!c || c->isHidden) continue;
    const QString sign = mark.verdict == Verdict::Met ? QStringLiteral("✓") : QStringLiteral("✗");
    lines += sign + QLatin1Char(' ') + nameWithTolerance(*c) + QStringLiteral(": ") + reasonText(mark);
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
      m_sizes(wrapped(this)),
      m_measure(new QPushButton(tr("&Measure"), this)),
      m_name(new QLineEdit(this)),
      m_handIn(new QPushButton(tr("&Hand in…"), this)) {
  m_begin->setObjectName(QStringLiteral("lesson/begin"));
  m_measure->setObjectName(QStringLiteral("lesson/measure"));
  m_measure->setToolTip(tr("Measure the sizes of the drawing on the part as it is now"));
  m_sizes->setObjectName(QStringLiteral("lesson/sizes"));
  m_name->setObjectName(QStringLiteral("lesson/name"));
  m_name->setMaxLength(static_cast<int>(Attempt::kLongestText / 4));  // a character of UTF-8 has at most 4 bytes
  m_name->setPlaceholderText(tr("Your name"));
  m_name->setAccessibleName(tr("Your name"));
  m_handIn->setObjectName(QStringLiteral("lesson/handIn"));
  // The text scrolls; the buttons stay.
  auto* page = new QWidget;
  auto* reading = new QVBoxLayout(page);
  reading->setContentsMargins(0, 0, 0, 0);
  reading->addWidget(m_text);
  reading->addWidget(m_begin);
  reading->addWidget(m_steps, 1);
  reading->addWidget(m_sizes);
  auto* column = new QVBoxLayout(this);
  m_reading = new ScrolledPanel(page, ScrolledPanel::Directions::Vertical, this);
  column->addWidget(m_reading, 1);
  for (QWidget* each : std::initializer_list<QWidget*>{m_measure, m_name, m_handIn}) column->addWidget(each);
  connect(m_begin, &QPushButton::clicked, this, &ExerciseLesson::begun);
  connect(m_measure, &QPushButton::clicked, this, &ExerciseLesson::measuringRequested);
  connect(m_name, &QLineEdit::textChanged, this, &ExerciseLesson::followName);
  connect(m_name, &QLineEdit::textEdited, this, [this](const QString& name) { emit nameChanged(name.trimmed()); });
  connect(m_handIn, &QPushButton::clicked, this, [this] { emit handInRequested(m_name->text().trimmed()); });
  connect(m_steps, &LessonPanel::hintShown, this, [this](int step, int count) {
    emit hintTaken(static_cast<std::size_t>(step), static_cast<std::size_t>(count));
  });
  connect(m_steps, &LessonPanel::stepDone, this, [this](int step) {
    m_steps->setStepState(static_cast<std::size_t>(step), LessonStep::State::Done);
    emit stepDone(static_cast<std::size_t>(step));
  });
}

void ExerciseLesson::setExercise(const ExerciseSnapshot& shown, const Attempt& attempt, bool isRunning) {
  const Exercise exercise = inLanguage(shown);
  m_isRunning = isRunning;
  m_text->setText(QString::fromStdString(exercise.text));
  std::vector<LessonStep> steps;
  for (std::size_t i = 0; i < exercise.steps.size(); ++i) steps.push_back(lessonStep(exercise, attempt, i));
  m_steps->setLesson(QString::fromStdString(exercise.title), std::move(steps));
  m_begin->setVisible(!isRunning);
  m_steps->setEnabled(isRunning);
  for (QWidget* each : std::initializer_list<QWidget*>{m_measure, m_name, m_handIn}) each->setVisible(isRunning);
  m_sizes->setText(drawingText(shown, exercise));
  m_sizes->setEnabled(true);
  m_isMeasured = false;
  m_name->setText(QString::fromStdString(attempt.student));
  setSeconds(attempt.seconds, exercise.allowedSeconds);
  followName();
}

void ExerciseLesson::setSeconds(double seconds, double allowed) {
  m_steps->setTime(seconds, allowed);
}

void ExerciseLesson::setMeasured(const ExerciseSnapshot& measured, const Marking& marking) {
  const Exercise exercise = inLanguage(measured);
  m_sizes->setText(measuredText(exercise, marking));
  m_sizes->setEnabled(true);
  m_isMeasured = true;
  // The sizes may be outside of the view, so scroll to them once they are laid out.
  QTimer::singleShot(0, this, [this] { m_reading->verticalScrollBar()->setValue(m_sizes->y()); });
}

void ExerciseLesson::setOutdated() {
  if (!std::exchange(m_isMeasured, false)) return;
  m_sizes->setText(tr("The work was changed since; measured before that:") + QLatin1Char('\n') + m_sizes->text());
  m_sizes->setEnabled(false);
}

void ExerciseLesson::setMet(const ExerciseSnapshot& measured, const Marking& marking) {
  const Exercise& exercise = measured.exercise;
  for (std::size_t i = 0; i < exercise.steps.size(); ++i) {
    if (exercise.steps[i].criteria.empty()) continue;
    m_steps->setStepState(i, isMet(exercise.steps[i], marking) ? LessonStep::State::Done : LessonStep::State::Open);
  }
}

void ExerciseLesson::followName() {
  const bool hasName = !m_name->text().trimmed().isEmpty();
  m_handIn->setEnabled(m_isRunning && hasName);
  m_handIn->setToolTip(hasName ? tr("Save a file for the teacher, with the part and all of its passes")
                               : tr("Write your name above first"));
}

}  // namespace handwheel
