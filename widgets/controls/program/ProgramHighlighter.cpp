// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramHighlighter.h"

#include "controls/program/ProgramMarks.h"

#include <QTextDocument>
#include <algorithm>
#include <array>
#include <span>

namespace handwheel {

namespace {

constexpr int kMostColoured = 4000;  // characters of a line: what is beyond keeps the colour of text

// Colours by EditorWord::Kind.
constexpr std::array<QRgb, 10> kLight{0xff616975, 0xff1f5fc4, 0xff9a5b00, 0xff0b7d5f, 0xff1d2128,
                                      0xff616975, 0xff8a3a8f, 0xff8a3a8f, 0xff1f5fc4, 0xffc02a25};
constexpr std::array<QRgb, 10> kDark{0xff9ba3af, 0xff7fb0ff, 0xfff0b24a, 0xff3ecf9f, 0xffe4e7eb,
                                     0xff9ba3af, 0xffd79ae0, 0xffd79ae0, 0xff7fb0ff, 0xffff6b63};

constexpr std::size_t kMostUnderlined = 20;  // marks of a line

}  // namespace

QColor programColour(EditorWord::Kind kind, ThemeKind theme) {
  return QColor((theme == ThemeKind::Dark ? kDark : kLight)[static_cast<std::size_t>(kind)]);
}

ProgramHighlighter::ProgramHighlighter(QTextDocument* document)
    : QSyntaxHighlighter(document), m_theme(currentTheme()) {}

void ProgramHighlighter::show(int first, int last) {
  m_first = first;
  m_last = last;
  for (QTextBlock line = document()->findBlockByNumber(first); line.isValid() && line.blockNumber() <= last;
       line = line.next()) {
    if (line.userState() != m_round) rehighlightBlock(line);
  }
}

void ProgramHighlighter::refresh() {
  m_theme = currentTheme();
  ++m_round;
  show(m_first, m_last);
}

void ProgramHighlighter::highlightBlock(const QString& text) {
  const int number = currentBlock().blockNumber();
  const bool isShown = number >= m_first && number <= m_last;
  setCurrentBlockState(isShown ? m_round : -1);
  if (!isShown) return;
  const std::vector<EditorWord> words = programWords(QStringView(text).left(kMostColoured));
  for (const EditorWord& word : words) setFormat(word.start, word.length, programColour(word.kind, m_theme));
  underline(text, words);
}

// Underlines from the marked column to the end of the word there; all of the line if no column is given.
void ProgramHighlighter::underline(const QString& text, const std::vector<EditorWord>& words) {
  const std::vector<ProgramMark>& marks = programMarks(currentBlock());
  for (const ProgramMark& mark : std::span(marks).first(std::min(marks.size(), kMostUnderlined))) {
    const int length = static_cast<int>(text.size());
    int start = mark.column > 0 ? std::min(mark.column - 1, std::max(0, length - 1)) : 0;
    int end = mark.column > 0 ? start + 1 : length;
    for (const EditorWord& word : words) {
      if (mark.column > 0 && start >= word.start && start < word.start + word.length) end = word.start + word.length;
    }
    end = std::min({end, length, kMostColoured});
    for (; start < end; ++start) {
      QTextCharFormat under = format(start);
      under.setUnderlineStyle(QTextCharFormat::WaveUnderline);
      under.setUnderlineColor(severityColour(mark.severity, themeColours(m_theme)));
      setFormat(start, 1, under);
    }
  }
}

}  // namespace handwheel
