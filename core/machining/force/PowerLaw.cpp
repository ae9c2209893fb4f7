// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/PowerLaw.h"

#include <cmath>

namespace handwheel {

double PowerLaw::at(const CutConditions& cut) const noexcept {
  return std::exp(logC + x * std::log(cut.depth) + y * std::log(cut.feed) + n * std::log(cut.speed));
}

}  // namespace handwheel
