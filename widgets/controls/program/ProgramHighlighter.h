// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/program/ProgramWords.h"
#include "theme/Theme.h"

#include <QColor>
#include <QSyntaxHighlighter>

namespace handwheel {

// The colour of a word in a program editor. It has a contrast of at least 4.5:1 on the ground of lists and fields.
QColor programColour(EditorWord::Kind kind, ThemeKind theme);

// Colours the words of a program and underlines what is marked. Only the lines that are shown are coloured, so that a
// long program opens at once: the editor says which.
class ProgramHighlighter : public QSyntaxHighlighter {
  Q_OBJECT

 public:
  explicit ProgramHighlighter(QTextDocument* document);

  // The lines that are shown, counted from 0. Colours those that are not yet.
  void show(int first, int last);
  // Colours what is shown anew: the marks or the theme are others.
  void refresh();

 protected:
  void highlightBlock(const QString& text) override;

 private:
  void underline(const QString& text, const std::vector<EditorWord>& words);

  int m_first = 0;
  int m_last = 0;
  int m_round = 1;  // lines with another number in their state have old colours, or none
  ThemeKind m_theme;
};

}  // namespace handwheel
