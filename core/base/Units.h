// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace handwheel {

// The physical quantity that a number measures. The program uses millimetres, radians and seconds internally.
enum class Quantity { Number, Length, Angle };

// The units in which lengths are shown.
enum class LengthUnit { Millimetre, Centimetre, Metre, Inch };

constexpr double millimetresPer(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Centimetre:
      return 10.0;
    case LengthUnit::Metre:
      return 1000.0;
    case LengthUnit::Inch:
      return 25.4;
    case LengthUnit::Millimetre:
      break;
  }
  return 1.0;
}

// Returns the symbol of a length unit: "mm", "cm", "m" or "in". It is used in files, on the command line and on the
// screen.
constexpr const char* symbolOf(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::Centimetre:
      return "cm";
    case LengthUnit::Metre:
      return "m";
    case LengthUnit::Inch:
      return "in";
    case LengthUnit::Millimetre:
      break;
  }
  return "mm";
}

inline constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;
static_assert(millimetresPer(LengthUnit::Inch) * 5.0 == 127.0);

}  // namespace handwheel
