// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/QuantityText.h"

#include "base/NumberText.h"

#include <QRegularExpression>
#include <cmath>

namespace handwheel {

double perShownUnit(Quantity quantity, LengthUnit unit) {
  switch (quantity) {
    case Quantity::Length:
      return millimetresPer(unit);
    case Quantity::Angle:
      return kRadiansPerDegree;
    case Quantity::Number:
      break;
  }
  return 1.0;
}

QString unitSymbol(Quantity quantity, LengthUnit unit) {
  switch (quantity) {
    case Quantity::Length:
      return QString::fromLatin1(symbolOf(unit));
    case Quantity::Angle:
      return QStringLiteral("°");
    case Quantity::Number:
      break;
  }
  return {};
}

QString numberText(double value, const QLocale& locale) {
  if (std::isnan(value)) return QStringLiteral("—");
  if (std::isinf(value)) return value > 0.0 ? QStringLiteral("∞") : QStringLiteral("−∞");
  return QString::fromStdString(shownText(value)).replace(QLatin1Char('.'), locale.decimalPoint());
}

QString quantityNumber(double value, Quantity quantity, LengthUnit unit, const QLocale& locale) {
  constexpr double kLeastAngle = 1e-9;  // degrees
  const double shown = value / perShownUnit(quantity, unit);
  return numberText(quantity == Quantity::Angle && std::abs(shown) < kLeastAngle ? 0.0 : shown, locale);
}

QString quantityText(double value, Quantity quantity, LengthUnit unit, const QLocale& locale) {
  const QString number = quantityNumber(value, quantity, unit, locale);
  const QString symbol = unitSymbol(quantity, unit);
  return quantity == Quantity::Length ? number + QChar::Nbsp + symbol : number + symbol;
}

QString withLocalNumbers(const QString& text, const QLocale& locale) {
  static const QRegularExpression kPoint(QStringLiteral("(?<=[0-9])[.](?=[0-9])"));
  return QString(text).replace(kPoint, locale.decimalPoint());
}

QString withPoints(const QString& text, const QLocale& locale) {
  const QRegularExpression separator("(?:,|" + QRegularExpression::escape(locale.decimalPoint()) + ")(?=[0-9])");
  return QString(text).replace(separator, QStringLiteral("."));
}

}  // namespace handwheel
