// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Tolerance.h"

#include <cmath>
#include <cstddef>

namespace handwheel {

// What the repair of a mesh of so many faces may take at most, in steps of Effort.
inline std::size_t repairEffort(std::size_t faces) {
  const double n = static_cast<double>(faces) + 2.0;
  return static_cast<std::size_t>(tolerance::kRepairEffort * n * std::log2(n));
}

}  // namespace handwheel
