// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

#include "base/Units.h"

namespace handwheel {

// What one unit shown on the screen is inside: mm, radian.
double perShownUnit(Quantity quantity, LengthUnit unit);

// "mm", "°"; nothing for numbers.
QString unitSymbol(Quantity quantity, LengthUnit unit);

// The shortest decimal number, in the language's digits and without separators of thousands, that is within one
// millionth of the value. Very large and very small ones have an exponent. "∞" and "—" for what is not finite.
QString numberText(double value, const QLocale& locale);

// A value in mm or radian as it is read: "12.7 mm", "90°".
QString quantityText(double value, Quantity quantity, LengthUnit unit, const QLocale& locale);

}  // namespace handwheel
