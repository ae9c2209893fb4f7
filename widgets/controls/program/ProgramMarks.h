// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "theme/Theme.h"

#include <QString>
#include <QTextBlock>
#include <vector>

class QTextDocument;

namespace handwheel {

// A remark about a position in a program: an error, a warning, a note. Lines and columns count from 1.
struct ProgramMark {
  enum class Severity { Note, Warning, Error };
  int line = 1;
  int column = 0;  // 0: the whole line
  Severity severity = Severity::Error;
  QString text;
  bool operator==(const ProgramMark&) const = default;
};

// Sets the marks of a document. The marks are attached to its lines and move with them while it is edited. Marks of
// lines beyond the end of the document are attached to its last line. O(lines + marks).
void setProgramMarks(QTextDocument& document, std::vector<ProgramMark> marks);

// Returns the marks of a line. The result is empty if there are none.
const std::vector<ProgramMark>& programMarks(const QTextBlock& line);

// Returns the worst severity of the marks, of which there must be at least one.
ProgramMark::Severity worstOf(const std::vector<ProgramMark>& marks);

QColor severityColour(ProgramMark::Severity severity, const ThemeColours& colours);

}  // namespace handwheel
