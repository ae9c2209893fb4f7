// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include "base/Units.h"

namespace handwheel {

// Returns the factor from the displayed unit to the internal one (mm, radian).
double perShownUnit(Quantity quantity, LengthUnit unit);

// Returns the symbol of the displayed unit: "mm", "°"; empty for plain numbers.
QString unitSymbol(Quantity quantity, LengthUnit unit);

// Formats a number with the fewest digits. The result is within one millionth of the value, in the locale's digits and
// without thousands separators. Very large and very small values have an exponent; infinite values are written as "∞"
// or "−∞", and NaN as "—".
QString numberText(double value, const QLocale& locale);

// Formats a value in mm or radian as a number in the displayed unit, without the unit symbol. Angles below a billionth
// of a degree are rounding errors and are written as 0.
QString quantityNumber(double value, Quantity quantity, LengthUnit unit, const QLocale& locale);

// Formats a value in mm or radian with its unit: "12.7 mm", "90°".
QString quantityText(double value, Quantity quantity, LengthUnit unit, const QLocale& locale);

// Returns the same text with the decimal separator of the locale in its numbers: "±0,05", "1,5; 2".
QString withLocalNumbers(const QString& text, const QLocale& locale);
// Returns the same text with a point as decimal separator in its numbers, for files. Numbers may have the decimal
// separator of the locale, a comma or a point, but no thousands separators.
QString withPoints(const QString& text, const QLocale& locale);

}  // namespace handwheel
