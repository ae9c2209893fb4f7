// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/fidelity/FitText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct FitTextWords {
  Q_DECLARE_TR_FUNCTIONS(FidelityPanel)
};

QString shareText(const FitShare& share, const QLocale& locale) {
  const QString used = locale.toString(100.0 * share.used / share.limit, 'g', 2);
  switch (share.budget) {
    case FidelityBudget::Core:
      return FitTextWords::tr("%1 % of a processor core for the servo loop").arg(used);
    case FidelityBudget::Tick:
      return FitTextWords::tr("%1 % of a servo tick (%2 µs)").arg(used, locale.toString(share.limit, 'f', 0));
    case FidelityBudget::Rate:
      return FitTextWords::tr("%1 % of the servo rate for stiffness").arg(used);
    case FidelityBudget::Frame:
      return FitTextWords::tr("%1 % of a frame (%2 ms)").arg(used, locale.toString(share.limit, 'f', 1));
    case FidelityBudget::Wait:
      return FitTextWords::tr("%1 % of a second for a repair").arg(used);
    default:
      return FitTextWords::tr("%1 % of a second for a fill").arg(used);
  }
}

}  // namespace

QString fitText(const FidelityFit& fit, const QLocale& locale) {
  QStringList shares;
  for (const FitShare& share : fit.shares) shares << shareText(share, locale);
  QString text = FitTextWords::tr("Most accurate value that leaves a third of the limit unused. Takes %1.")
                     .arg(shares.join(QStringLiteral(", ")));
  for (const FittedSetting& s : fit.settings) {
    if (!s.isOver) continue;
    const QString label = QCoreApplication::translate("Fidelity", s.setting.label.c_str());
    text += QLatin1Char(' ') + FitTextWords::tr("%1: no value is fast enough, the fastest is used.").arg(label);
  }
  return text;
}

}  // namespace handwheel
