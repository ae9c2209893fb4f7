// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/ValueSnapping.h"

#include <cmath>

namespace handwheel {

double snappedTo(double value, double least) {
  const double exponent = std::floor(std::log10(least));
  const double power = std::pow(10.0, std::abs(exponent));  // exact, so that 0.3 is the number 0.3
  const auto inPowers = [&](double x) { return exponent < 0.0 ? x * power : x / power; };
  double factor = 1.0;
  for (double next : {2.0, 5.0, 10.0}) {
    if (factor < inPowers(least) * (1.0 - 1e-9)) factor = next;
  }
  const double count = std::round(inPowers(value) / factor) * factor;
  return exponent < 0.0 ? count / power : count * power;
}

}  // namespace handwheel
