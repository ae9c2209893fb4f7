// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/NoteText.h"

#include "text/RepairText.h"

#include <QCoreApplication>

namespace handwheel {

QString noteText(const Note& note) {
  QString sentence = QCoreApplication::translate("Note", note.text.c_str());
  if (note.state) sentence.replace(QStringLiteral("%1"), stateText(*note.state));
  for (std::size_t i = 0; i < note.arguments.size(); ++i) {
    sentence.replace(QLatin1Char('%') + QString::number(i + 1), QString::fromStdString(note.arguments[i]));
  }
  return sentence;
}

}  // namespace handwheel
