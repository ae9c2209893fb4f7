// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/program/ProgramWords.h"
#include "theme/Theme.h"

#include <QColor>
#include <QSyntaxHighlighter>

namespace handwheel {

// Returns the colour of a word in a program editor. The colour has a contrast of at least 4.5:1 on the background of
// lists and fields.
QColor programColour(EditorWord::Kind kind, ThemeKind theme);

// A highlighter that colours the words of a program and underlines marked words. Only the lines that the editor reports
// as visible are coloured, so that a long program opens at once.
class ProgramHighlighter : public QSyntaxHighlighter {
  Q_OBJECT

 public:
  explicit ProgramHighlighter(QTextDocument* document);

  // Sets the visible lines, counted from 0. Colours those lines that are not coloured yet.
  void show(int first, int last);
  // Colours the visible lines again, after a change of the marks or the theme.
  void refresh();

 protected:
  void highlightBlock(const QString& text) override;

 private:
  void underline(const QString& text, const std::vector<EditorWord>& words);

  int m_first = 0;
  int m_last = 0;
  // The number of the present colouring. Lines with another number in their state have outdated colours or none.
  int m_round = 1;
  ThemeKind m_theme;
};

}  // namespace handwheel
