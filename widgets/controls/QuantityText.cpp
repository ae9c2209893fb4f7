// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/QuantityText.h"

#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kPrecision = 1e-6;  // relative
// Outside, an exponent reads better than zeros.
constexpr double kSmallestFixed = 1e-7;
constexpr double kLargestFixed = 1e12;

// The shortest text of this form that is near enough, in the C locale.
QByteArray shortest(double value, std::chars_format form) {
  char text[512];
  for (int digits = 0;; ++digits) {
    char* end = std::to_chars(text, text + sizeof text, value, form, digits).ptr;
    double read = 0.0;
    std::from_chars(text, end, read, form);
    if (digits == 17 || std::abs(read - value) <= kPrecision * std::abs(value)) return {text, end - text};
  }
}

}  // namespace

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
  const double size = std::abs(value);
  const bool fixed = size == 0.0 || (size >= kSmallestFixed && size < kLargestFixed);
  // Adding zero takes the sign from a negative zero.
  const QByteArray text = shortest(value + 0.0, fixed ? std::chars_format::fixed : std::chars_format::scientific);
  return QString::fromLatin1(text).replace(QLatin1Char('.'), locale.decimalPoint());
}

QString quantityText(double value, Quantity quantity, LengthUnit unit, const QLocale& locale) {
  const QString number = numberText(value / perShownUnit(quantity, unit), locale);
  const QString symbol = unitSymbol(quantity, unit);
  return quantity == Quantity::Length ? number + QChar::Nbsp + symbol : number + symbol;
}

}  // namespace handwheel
