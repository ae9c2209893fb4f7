// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/FitText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(FidelityPanel)
};

// Of what, with how much there is of it.
QString nameOf(const FitShare& share, const QLocale& locale) {
  const QString limit = locale.toString(share.limit, 'g', 3);
  switch (share.budget) {
    case FidelityBudget::Core:
      return Text::tr("processor core of the servo loop");
    case FidelityBudget::Tick:
      return Text::tr("servo tick of %1 µs").arg(limit);
    case FidelityBudget::Rate:
      return Text::tr("%1 ticks a second for stiffness").arg(locale.toString(share.limit, 'f', 0));
    case FidelityBudget::Frame:
      return Text::tr("frame of %1 ms").arg(limit);
    case FidelityBudget::Wait:
      return Text::tr("wait of a second for a repair");
    default:
      return Text::tr("wait of a second for a fill");
  }
}

}  // namespace

QString fitText(const FidelityFit& fit, const QLocale& locale) {
  QStringList shares;
  for (const FitShare& share : fit.shares)
    shares << Text::tr("%1 % of a %2")
                  .arg(locale.toString(100.0 * share.used / share.limit, 'g', 2), nameOf(share, locale));
  QString text = Text::tr("Fit takes the most accurate values that leave a third to spare. It uses %1.")
                     .arg(shares.join(QStringLiteral(", ")));
  for (const FittedSetting& s : fit.settings) {
    if (!s.isOver) continue;
    const QString label = QCoreApplication::translate("Fidelity", s.setting.label.c_str());
    text += QLatin1Char(' ') + Text::tr("%1: no value is fast enough, the fastest is taken.").arg(label);
  }
  return text;
}

}  // namespace handwheel
