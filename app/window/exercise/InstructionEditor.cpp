// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/InstructionEditor.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kRows = 4;  // rows visible at once

QListWidget* listIn(QVBoxLayout& column, QWidget* parent, const QString& heading, const QString& name) {
  auto* label = new QLabel(heading, parent);
  label->setWordWrap(true);
  auto* list = new QListWidget(parent);
  list->setObjectName(name);
  list->setAccessibleName(heading);
  list->setWordWrap(true);
  list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list->setMaximumHeight(kRows * (list->fontMetrics().height() + 8));
  column.addWidget(label);
  column.addWidget(list);
  return list;
}

// Remaining rows keep their index, so that editing continues.
void setCount(QListWidget& list, std::size_t count) {
  while (list.count() > static_cast<int>(count)) delete list.takeItem(list.count() - 1);
  while (list.count() < static_cast<int>(count)) list.addItem(QString());
}

}  // namespace

InstructionEditor::InstructionEditor(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  m_marks = listIn(*column, this, tr("Done when these criteria are met:"), QStringLiteral("steps/marks"));
  makeHints(*column);
  connect(m_marks, &QListWidget::itemChanged, this,
          [this](QListWidgetItem* item) { emit markToggled(item->data(Qt::UserRole).toString().toStdString()); });
}

void InstructionEditor::makeHints(QVBoxLayout& column) {
  m_hints = listIn(column, this, tr("Hints, shown one after another; double-click to change one:"),
                   QStringLiteral("steps/hints"));
  m_hints->setEditTriggers(QListWidget::DoubleClicked | QListWidget::EditKeyPressed | QListWidget::AnyKeyPressed);
  connect(m_hints, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
    emit hintChanged(static_cast<std::size_t>(m_hints->row(item)), item->text().trimmed().toStdString());
  });
  auto* buttons = new QHBoxLayout;
  m_add = new QToolButton(this);
  m_add->setObjectName(QStringLiteral("steps/addHint"));
  m_add->setText(tr("Add a hint"));
  m_remove = new QToolButton(this);
  m_remove->setObjectName(QStringLiteral("steps/removeHint"));
  m_remove->setText(tr("Remove the hint"));
  for (QToolButton* each : {m_add, m_remove}) buttons->addWidget(each);
  buttons->addStretch(1);
  column.addLayout(buttons);
  connect(m_add, &QToolButton::clicked, this, [this] {
    emit hintAdded();
    if (m_hints->count() == 0) return;
    m_hints->setCurrentRow(m_hints->count() - 1);
    m_hints->editItem(m_hints->currentItem());
  });
  connect(m_remove, &QToolButton::clicked, this, [this] {
    const int row = m_hints->currentRow();
    if (row >= 0) emit hintRemoved(static_cast<std::size_t>(row));
  });
  connect(m_hints, &QListWidget::currentRowChanged, this, [this](int row) { m_remove->setEnabled(row >= 0); });
}

void InstructionEditor::show(const Exercise& exercise, int step) {
  setEnabled(step >= 0);
  const ExerciseStep none, &shown = step < 0 ? none : exercise.steps[static_cast<std::size_t>(step)];
  const QSignalBlocker noMark(m_marks), noHint(m_hints);
  setCount(*m_marks, exercise.criteria.size());
  for (int i = 0; i < m_marks->count(); ++i) {
    const MarkingCriterion& c = exercise.criteria[static_cast<std::size_t>(i)];
    QListWidgetItem* const item = m_marks->item(i);
    const bool isChosen = std::find(shown.criteria.begin(), shown.criteria.end(), c.id) != shown.criteria.end();
    item->setText(QString::fromStdString(c.name.empty() ? c.id : c.name));
    item->setData(Qt::UserRole, QString::fromStdString(c.id));
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(isChosen ? Qt::Checked : Qt::Unchecked);
  }
  setCount(*m_hints, shown.hints.size());
  for (int i = 0; i < m_hints->count(); ++i) {
    m_hints->item(i)->setText(QString::fromStdString(shown.hints[static_cast<std::size_t>(i)]));
    m_hints->item(i)->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsEditable);
  }
  m_add->setEnabled(shown.hints.size() < Exercise::kMostHints);
  m_remove->setEnabled(m_hints->currentRow() >= 0);
}

}  // namespace handwheel
