// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/SuggestedName.h"

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
  const QString name = parts.join(QStringLiteral(", ")).left(kLongest).trimmed();
  return (name.isEmpty() ? QStringLiteral("untitled") : name) + QLatin1Char('.') + ending;
}

}  // namespace handwheel
