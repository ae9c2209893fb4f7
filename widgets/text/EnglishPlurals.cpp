// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/EnglishPlurals.h"

namespace handwheel {

QString EnglishPlurals::translate(const char*, const char* source, const char*, int n) const {
  QString text = QString::fromUtf8(source);
  const bool isRegular = text.contains(QLatin1String("(s)")), isOnY = text.contains(QLatin1String("y(ies)"));
  const bool isOnEx = text.contains(QLatin1String("ex(ices)"));
  if (n < 0 || (!isRegular && !isOnY && !isOnEx)) return {};
  text.replace(QLatin1String("y(ies)"), QLatin1String(n == 1 ? "y" : "ies"));
  text.replace(QLatin1String("ex(ices)"), QLatin1String(n == 1 ? "ex" : "ices"));
  return text.replace(QLatin1String("(s)"), QLatin1String(n == 1 ? "" : "s"));
}

}  // namespace handwheel
