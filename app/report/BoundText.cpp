// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/BoundText.h"

#include "base/NumberText.h"

#include <charconv>
#include <cmath>

namespace handwheel {

std::string roundedUpText(double value, int digits) {
  const std::string text = roundedText(value, digits);
  double read = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), read);
  // A unit of the last digit is at most so large a share of the value.
  return read < value ? roundedText(value + std::abs(value) * std::pow(10.0, 1 - digits), digits) : text;
}

}  // namespace handwheel
