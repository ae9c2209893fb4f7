// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/program/ProgramMarks.h"

#include <QPlainTextEdit>
#include <functional>
#include <vector>

namespace handwheel {

class ProgramHighlighter;
class ProgramMargin;
class ProgramSearchBar;

// An editor of machine programs with line numbers, coloured words, marks and search. Marks are drawn in the margin,
// under the words and in tool tips; F8 and Shift+F8 go to the next and the previous mark, Ctrl+F searches, and F3 and
// Shift+F3 continue the search forwards and backwards. Tab leaves the editor. Only the visible lines are coloured, so
// that a program of 100,000 lines opens at once. Lines and columns count from 1. All calls must be made on the window
// thread.
class ProgramEditor : public QPlainTextEdit {
  Q_OBJECT

 public:
  using Mark = ProgramMark;

  explicit ProgramEditor(QWidget* parent = nullptr);

  // Replaces all marks. Until the next call, they move with their lines while the program is edited.
  void setMarks(std::vector<Mark> marks);
  // Sets the executed line and scrolls it into view; 0: none. The cursor does not move.
  void setCurrentLine(int line);
  int currentLine() const { return m_currentLine; }
  // Moves the cursor to a position and scrolls it into view. A position beyond the end of the program means its end.
  void goTo(int line, int column = 1);
  // Goes to the next mark after the cursor, or to the previous one before it. Continues at the other end of the program
  // if necessary. Returns false if there are no marks.
  bool goToMark(bool backwards = false);
  // Selects the next or the previous occurrence of a text, ignoring case. Continues at the other end of the program if
  // necessary. Returns false if the text does not occur.
  bool findText(const QString& text, bool backwards = false);

  // Returns the texts of the marks of a line, separated by line feeds. The result is empty if the line has no marks.
  QString markText(const QTextBlock& line) const;
  // Calls visit(line, its rectangle in the viewport) for each visible line, from the top.
  void forEachShownLine(const std::function<void(const QTextBlock&, const QRectF&)>& visit) const;
  void scrollByWheel(QWheelEvent* event) { wheelEvent(event); }

  QSize sizeHint() const override;

 signals:
  void cursorLineChanged(int line);

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  bool viewportEvent(QEvent* event) override;

 private:
  void layOut();
  void colourShown();
  void showLines();

  ProgramHighlighter* m_highlighter;
  ProgramMargin* m_margin;
  ProgramSearchBar* m_search;
  int m_currentLine = 0;
  int m_cursorLine = 1;
};

}  // namespace handwheel
