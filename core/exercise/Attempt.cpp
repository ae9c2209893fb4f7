// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "exercise/Attempt.h"

#include <numeric>

namespace handwheel {

std::size_t Attempt::hintCount() const {
  return std::accumulate(hints.begin(), hints.end(), std::size_t{0});
}

}  // namespace handwheel
