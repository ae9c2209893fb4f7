// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/SuggestedName.h"

#include <algorithm>

namespace handwheel {

QString fileNameOf(const QStringList& words, const QString& ending) {
  constexpr int kLongest = 60;  // signs, so that four bytes each are within the 255 of most file systems
  QStringList parts;
  for (const QString& word : words) {
    QString part = word;
    for (QChar& sign : part) {
      if (!sign.isPrint() || QStringLiteral("/\\:*?\"<>|").contains(sign)) sign = QLatin1Char(' ');
    }
    part = part.simplified();
    while (part.startsWith(QLatin1Char('.'))) part.remove(0, 1);
    if (!part.isEmpty()) parts += part;
  }
  // The last word distinguishes files of the same beginning.
  const QString separator = QStringLiteral(", ");
  const QString rest = parts.size() < 2 ? QString() : separator + parts.mid(1).join(separator);
  const qsizetype room = std::max(kLongest - rest.size(), qsizetype{0});
  const QString name = (parts.value(0).left(room).trimmed() + rest).left(kLongest).trimmed();
  return (name.isEmpty() ? QStringLiteral("untitled") : name) + QLatin1Char('.') + ending;
}

}  // namespace handwheel
