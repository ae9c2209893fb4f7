// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exercise/Exercise.h"

#include <QWidget>

class QListWidget;
class QToolButton;
class QVBoxLayout;

namespace handwheel {

// Edits the lists of an exercise step: its criteria and its hints. The criteria that tick the step are a list of check
// boxes; hints have a row each.
class InstructionEditor : public QWidget {
  Q_OBJECT

 public:
  explicit InstructionEditor(QWidget* parent = nullptr);

  // exercise: in the language of the window. step: -1 for none.
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
