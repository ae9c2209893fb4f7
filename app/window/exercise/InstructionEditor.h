// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Exercise.h"

#include <QWidget>

class QListWidget;
class QToolButton;
class QVBoxLayout;

namespace handwheel {

// A widget that edits the criteria and the hints of an exercise step. The criteria that tick the step are chosen in a
// list of check boxes; each hint has its own row.
class InstructionEditor : public QWidget {
  Q_OBJECT

 public:
  explicit InstructionEditor(QWidget* parent = nullptr);

  // Shows a step of an exercise. exercise: the exercise in the language of the window; step: the index of the step, or
  // -1 for no step.
  void show(const Exercise& exercise, int step);

 signals:
  void markToggled(const std::string& id);
  void hintAdded();
  void hintChanged(std::size_t hint, const std::string& text);
  void hintRemoved(std::size_t hint);

 private:
  void makeHints(QVBoxLayout& column);

  QListWidget* m_marks;
  QListWidget* m_hints;
  QToolButton* m_add;
  QToolButton* m_remove;
};

}  // namespace handwheel
