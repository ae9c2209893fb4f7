// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramMarks.h"

#include <QTextDocument>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

class LineMarks final : public QTextBlockUserData {
 public:
  std::vector<ProgramMark> marks;
};

LineMarks* marksOf(const QTextBlock& line) {
  return dynamic_cast<LineMarks*>(line.userData());
}

}  // namespace

void setProgramMarks(QTextDocument& document, std::vector<ProgramMark> marks) {
  for (QTextBlock line = document.begin(); line.isValid(); line = line.next()) {
    if (line.userData()) line.setUserData(nullptr);
  }
  for (ProgramMark& mark : marks) {
    QTextBlock line = document.findBlockByNumber(std::clamp(mark.line, 1, document.blockCount()) - 1);
    if (!marksOf(line)) line.setUserData(new LineMarks);
    marksOf(line)->marks.push_back(std::move(mark));
  }
}

const std::vector<ProgramMark>& programMarks(const QTextBlock& line) {
  static const std::vector<ProgramMark> none;
  const LineMarks* marks = marksOf(line);
  return marks ? marks->marks : none;
}

ProgramMark::Severity worstOf(const std::vector<ProgramMark>& marks) {
  ProgramMark::Severity worst = ProgramMark::Severity::Note;
  for (const ProgramMark& mark : marks) worst = std::max(worst, mark.severity);
  return worst;
}

QColor severityColour(ProgramMark::Severity severity, const ThemeColours& colours) {
  switch (severity) {
    case ProgramMark::Severity::Note:
      return colours.accent;
    case ProgramMark::Severity::Warning:
      return colours.warning;
    case ProgramMark::Severity::Error:
      break;
  }
  return colours.error;
}

}  // namespace handwheel
