// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/exercise/ReasonText.h"

#include "text/NoteText.h"

namespace handwheel {

QString exerciseText(const ExerciseText& text) {
  return noteText({text.text, text.arguments});
}

QString reasonText(const Mark& mark) {
  const QString reason = exerciseText(mark.reason);
  return mark.remark.text.empty() ? reason : QStringLiteral("%1 (%2)").arg(reason, exerciseText(mark.remark));
}

}  // namespace handwheel
