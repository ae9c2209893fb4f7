// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/ExerciseEditor.h"

#include "controls/ScrolledPanel.h"
#include "controls/property/PropertyList.h"
#include "document/exercise/ExerciseProperties.h"
#include "document/exercise/ExerciseRows.h"
#include "document/exercise/ShippedExercises.h"
#include "panels/ActionButton.h"
#include "window/documents/DocumentProperties.h"
#include "window/exercise/InstructionEditor.h"
#include "window/exercise/SubmissionsView.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

std::vector<Property> beginningWith(const std::vector<Property>& all, const std::string& prefix) {
  std::vector<Property> some;
  for (const Property& property : all) {
    if (property.id.starts_with(prefix)) some.push_back(property);
  }
  return some;
}

// Neither of a criterion nor of a step.
std::vector<Property> ofTask(const std::vector<Property>& all) {
  std::vector<Property> some;
  for (const Property& property : all) {
    if (!property.id.starts_with("criterion.") && !property.id.starts_with("step.")) some.push_back(property);
  }
  return some;
}

// Returns the properties without those that the step editor shows as lists: hints and criteria of steps.
std::vector<Property> withoutLists(std::vector<Property> all) {
  std::erase_if(all, [](const Property& each) {
    return each.id.starts_with("step.") && (each.id.ends_with(".hints") || each.id.ends_with(".criteria"));
  });
  return all;
}

// "⌀30, Diameter: From Z −38, To Z −1": heights as on the drawing.
QString describedSize(const ExerciseSnapshot& exercise, const MarkingCriterion& size) {
  const std::vector<MeasurementType> types = measurementTypes(*exercise.subject);
  const MeasurementType* type = measurementType(types, size.figure);
  QString text = QString::fromStdString(size.name);
  if (!type) return text;
  const double zero = exercise.subject->drawingZero(*exercise.task).value_or(0.0);
  QStringList positions;
  for (std::size_t i = 0; i < type->arguments.size() && i < size.arguments.size(); ++i) {
    if (!type->arguments[i].ends_with('Z')) continue;
    const double z = std::round(1e3 * (size.arguments[i] - zero)) / 1e3 + 0.0;
    positions << QCoreApplication::translate("Property", type->arguments[i].c_str()) + QLatin1Char(' ') +
                     QLocale().toString(z);
  }
  return QStringLiteral("%1, %2: %3")
      .arg(text, QCoreApplication::translate("Figure", type->label.c_str()), positions.join(QStringLiteral(", ")));
}

}  // namespace

ExerciseEditor::ExerciseEditor(QWidget* parent)
    : QTabWidget(parent), m_task(new PropertyList(this)), m_taskPage(new QWidget(this)) {
  setObjectName(QStringLiteral("exerciseEditor"));
  setDocumentMode(true);
  auto* task = new QVBoxLayout(m_taskPage);
  task->setContentsMargins(0, 0, 8, 8);
  task->addWidget(m_task, 1);
  m_task->reserveRemarkSpace();
  const auto present = [this]() -> Document* { return m_document; };
  connectEdits(*m_task, present, this);
  m_criteria = makeRows(QStringLiteral("criteria"), tr("Add what is marked"), [this](QToolButton* add) {
    auto* menu = new QMenu(add);
    add->setMenu(menu);
    add->setPopupMode(QToolButton::InstantPopup);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] {
      menu->clear();
      if (!m_document) return;
      addSizes(*menu);
      const std::vector<MeasurementType> types = measurementTypes(*m_document->exercise().subject);
      for (std::size_t i = 0; i < types.size(); ++i) {
        QAction* action = menu->addAction(QCoreApplication::translate("Figure", types[i].label.c_str()));
        connect(action, &QAction::triggered, this, [this, i] { addCriterion(i); });
      }
    });
  });
  m_steps = makeRows(QStringLiteral("steps"), tr("Add a step"), [this](QToolButton* add) {
    connect(add, &QToolButton::clicked, this, [this] {
      if (m_document) change(tr("Add a step"), withNewStep(m_document->exercise()));
      m_steps.list->setCurrentRow(m_steps.list->count() - 1);
    });
  });
  m_criteria.properties->reserveRemarkSpace();
  connect(m_criteria.remove, &QToolButton::clicked, this, [this] {
    const int row = m_criteria.list->currentRow();
    if (!m_document || row < 0) return;
    const ExerciseSnapshot& exercise = m_document->exercise();
    change(tr("Remove a criterion"),
           withoutCriterion(exercise, exercise.exercise.criteria[static_cast<std::size_t>(row)].id));
  });
  connect(m_steps.remove, &QToolButton::clicked, this, [this] {
    const int row = m_steps.list->currentRow();
    if (m_document && row >= 0)
      change(tr("Remove a step"), withoutStep(m_document->exercise(), static_cast<std::size_t>(row)));
  });
  makeInstructionEditor();
  connectMoves(m_criteria, tr("Move a criterion"), withMovedCriterion);
  connectMoves(m_steps, tr("Move a step"), withMovedStep);
  m_class = new SubmissionsView(this);
  addTab(m_taskPage, tr("Task"));
  addTab(m_criteria.page, tr("Criteria"));
  addTab(m_steps.page, tr("Steps"));
  addTab(m_class, tr("Class"));
}

void ExerciseEditor::showTargetActions(const QList<QAction*>& actions) {
  for (QAction* action : actions) m_taskPage->layout()->addWidget(new ActionButton(action));
}

ExerciseEditor::Rows ExerciseEditor::makeRows(const QString& name, const QString& addTip,
                                              const std::function<void(QToolButton*)>& setUpAdding) {
  Rows rows;
  rows.page = new QWidget(this);
  auto* column = new QVBoxLayout(rows.page);
  auto* buttons = new QHBoxLayout;
  auto* add = new QToolButton(rows.page);
  add->setText(tr("Add"));
  add->setToolTip(addTip);
  add->setObjectName(name + QStringLiteral("/add"));
  rows.remove = new QToolButton(rows.page);
  rows.remove->setText(tr("Remove"));
  rows.remove->setObjectName(name + QStringLiteral("/remove"));
  rows.remove->setToolTip(tr("Remove the selected row"));
  rows.up = new QToolButton(rows.page);
  rows.up->setText(tr("Up"));
  rows.up->setObjectName(name + QStringLiteral("/up"));
  rows.up->setToolTip(tr("Move the selected row up"));
  rows.down = new QToolButton(rows.page);
  rows.down->setText(tr("Down"));
  rows.down->setObjectName(name + QStringLiteral("/down"));
  rows.down->setToolTip(tr("Move the selected row down"));
  for (QToolButton* each : {add, rows.remove, rows.up, rows.down}) buttons->addWidget(each);
  buttons->addStretch(1);
  rows.sum = new QLabel(rows.page);
  rows.sum->setObjectName(name + QStringLiteral("/sum"));
  buttons->addWidget(rows.sum);
  rows.list = new QListWidget(rows.page);
  rows.list->setObjectName(name);
  rows.list->setAccessibleName(addTip);
  rows.list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  rows.list->setWordWrap(true);
  rows.properties = new PropertyList(rows.page);
  column->addLayout(buttons);
  column->addWidget(rows.list, 1);
  column->addWidget(rows.properties, 2);
  setUpAdding(add);
  connectEdits(
      *rows.properties, [this]() -> Document* { return m_document; }, this);
  connect(rows.list, &QListWidget::currentRowChanged, this, &ExerciseEditor::refresh);
  return rows;
}

// Makes the editor of the lists of a step.
void ExerciseEditor::makeInstructionEditor() {
  m_step = new InstructionEditor(m_steps.page);
  m_steps.page->layout()->addWidget(new ScrolledPanel(m_step, ScrolledPanel::Directions::Vertical));
  connect(m_step, &InstructionEditor::markToggled, this, &ExerciseEditor::toggleMark);
  connect(m_step, &InstructionEditor::hintAdded, this, &ExerciseEditor::addHint);
  connect(m_step, &InstructionEditor::hintChanged, this, &ExerciseEditor::changeHint);
  connect(m_step, &InstructionEditor::hintRemoved, this, &ExerciseEditor::removeHint);
}

std::optional<ExerciseSnapshot> ExerciseEditor::withHints(
    const std::function<void(std::vector<std::string>&)>& changing) const {
  const int row = m_steps.list->currentRow();
  if (!m_document || row < 0) return std::nullopt;
  ExerciseSnapshot exercise = m_document->exercise();
  changing(exercise.exercise.steps[static_cast<std::size_t>(row)].hints);
  return exercise;
}

std::string ExerciseEditor::partOfHint(std::size_t hint) const {
  return "step." + std::to_string(m_steps.list->currentRow()) + ".hint." + std::to_string(hint);
}

// The text of the hint, which is typed next, belongs to the same undo step.
void ExerciseEditor::addHint() {
  std::size_t added = 0;
  auto exercise = withHints([&](std::vector<std::string>& hints) {
    added = hints.size();
    hints.push_back(tr("New hint").toStdString());
  });
  if (exercise) m_document->change(tr("Add a hint"), std::move(*exercise), partOfHint(added), DragPhase::Continues);
}

void ExerciseEditor::changeHint(std::size_t hint, const std::string& text) {
  auto exercise = withHints([&](std::vector<std::string>& hints) {
    if (hint < hints.size()) hints[hint] = text;
    std::erase(hints, std::string());
  });
  if (exercise) m_document->change(tr("Change a hint"), std::move(*exercise), partOfHint(hint), DragPhase::Ends);
}

void ExerciseEditor::removeHint(std::size_t hint) {
  auto exercise = withHints([&](std::vector<std::string>& hints) {
    if (hint < hints.size()) hints.erase(hints.begin() + static_cast<std::ptrdiff_t>(hint));
  });
  if (exercise) change(tr("Remove a hint"), std::move(*exercise));
}

void ExerciseEditor::toggleMark(const std::string& id) {
  const int row = m_steps.list->currentRow();
  if (!m_document || row < 0) return;
  ExerciseSnapshot exercise = m_document->exercise();
  std::vector<std::string>& met = exercise.exercise.steps[static_cast<std::size_t>(row)].criteria;
  if (std::erase(met, id) == 0) met.push_back(id);
  change(tr("Choose the criteria of a step"), std::move(exercise));
}

void ExerciseEditor::connectMoves(Rows& rows, const QString& text, Move moved) {
  for (const bool isUp : {true, false}) {
    connect(isUp ? rows.up : rows.down, &QToolButton::clicked, this, [this, list = rows.list, text, moved, isUp] {
      const int row = list->currentRow();
      if (!m_document || row < 0) return;
      change(text, moved(m_document->exercise(), static_cast<std::size_t>(row), isUp));
      list->setCurrentRow(row + (isUp ? -1 : 1));
    });
  }
}

void ExerciseEditor::setDocument(ExerciseDocument* document) {
  if (m_document) m_document->disconnect(this);
  if (document != m_document) {
    // A text that was refused must not be shown for another one.
    for (PropertyList* list : {m_task, m_criteria.properties, m_steps.properties}) list->setProperties({});
  }
  m_document = document;
  if (document) connect(document, &Document::changed, this, &ExerciseEditor::refresh);
  refresh();
}

void ExerciseEditor::refresh() {
  if (!m_document) return;
  const Exercise exercise = inLanguage(m_document->exercise());
  m_task->setLengthUnit(m_document->displayUnit());
  const std::vector<Property> properties = exerciseProperties(m_document->exercise());
  m_task->setProperties(ofTask(properties));
  QStringList criteria, steps;
  for (const MarkingCriterion& c : exercise.criteria) {
    const QString points = c.points == 1.0 ? tr("1 point") : tr("%1 points").arg(QLocale().toString(c.points));
    criteria += tr("%1 (%2)").arg(QString::fromStdString(c.name.empty() ? c.id : c.name), points);
  }
  for (std::size_t i = 0; i < exercise.steps.size(); ++i)
    steps += tr("%1. %2").arg(i + 1).arg(QString::fromStdString(exercise.steps[i].title));
  fillRows(m_criteria, criteria, properties,
           [&](int row) { return criterionPrefix(exercise.criteria[static_cast<std::size_t>(row)]); });
  m_criteria.sum->setText(tr("Points: %1").arg(QLocale().toString(exercise.points())));
  fillRows(m_steps, steps, withoutLists(properties), [](int row) { return stepPrefix(static_cast<std::size_t>(row)); });
  m_step->show(exercise, m_steps.list->currentRow());
}

void ExerciseEditor::fillRows(Rows& rows, const QStringList& names, const std::vector<Property>& properties,
                              const std::function<std::string(int)>& prefix) {
  const QSignalBlocker blocker(rows.list);
  const int before = rows.list->currentRow();
  while (rows.list->count() > names.size()) delete rows.list->takeItem(rows.list->count() - 1);
  while (rows.list->count() < names.size()) rows.list->addItem(QString());
  for (int i = 0; i < names.size(); ++i) rows.list->item(i)->setText(names[i]);
  const int row = names.isEmpty() ? -1 : std::clamp(before, 0, static_cast<int>(names.size()) - 1);
  rows.list->setCurrentRow(row);
  rows.remove->setEnabled(row >= 0);
  rows.up->setEnabled(row > 0);
  rows.down->setEnabled(row >= 0 && row + 1 < names.size());
  rows.properties->setProperties(row < 0 ? std::vector<Property>() : beginningWith(properties, prefix(row)));
}

// Adds menu items for the sizes of the target that are not in the marking scheme: all at once, and each.
void ExerciseEditor::addSizes(QMenu& menu) {
  const ExerciseSnapshot& exercise = m_document->exercise();
  const std::vector<MarkingCriterion> sizes = unmarkedSizes(exercise);
  if (sizes.empty()) return;
  const auto add = [this](std::vector<MarkingCriterion> added) {
    change(tr("Add %Ln size(s) of the target", nullptr, static_cast<int>(added.size())),
           withCriteria(m_document->exercise(), std::move(added)));
    m_criteria.list->setCurrentRow(m_criteria.list->count() - 1);
  };
  QAction* all = menu.addAction(tr("All %Ln size(s) of the target", nullptr, static_cast<int>(sizes.size())));
  all->setObjectName(QStringLiteral("criteria/addAllSizes"));
  connect(all, &QAction::triggered, this, [add, sizes] { add(sizes); });
  QMenu* each = menu.addMenu(tr("A size of the target"));
  each->setObjectName(QStringLiteral("criteria/sizes"));
  for (const MarkingCriterion& size : sizes) {
    QAction* action = each->addAction(describedSize(exercise, size));
    connect(action, &QAction::triggered, this, [add, size] { add({size}); });
  }
  menu.addSeparator();
}

void ExerciseEditor::addCriterion(std::size_t figure) {
  if (!m_document) return;
  const ExerciseSnapshot& exercise = m_document->exercise();
  change(tr("Add a criterion"), withNewCriterion(exercise, measurementTypes(*exercise.subject)[figure]));
  m_criteria.list->setCurrentRow(m_criteria.list->count() - 1);
}

void ExerciseEditor::change(const QString& text, ExerciseSnapshot exercise) {
  m_document->change(text, std::move(exercise));
}

}  // namespace handwheel
