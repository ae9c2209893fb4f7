// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;

namespace handwheel {

class ProgramEditor;

// A bar below a program for incremental search. Enter goes to the next occurrence, Shift+Enter to the previous one, and
// Esc closes the bar.
class ProgramSearchBar : public QWidget {
  Q_OBJECT

 public:
  explicit ProgramSearchBar(ProgramEditor* editor);

  // Shows the bar with a text to search for. If the text is empty, the last one is kept.
  void start(const QString& text);
  // Goes to the next occurrence of the text, or the previous one.
  void go(bool backwards);

 signals:
  void closed();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void searchFromSelection();
  void showFound(bool isFound);

  ProgramEditor* m_editor;
  QLineEdit* m_text;
  QLabel* m_state;
};

}  // namespace handwheel
