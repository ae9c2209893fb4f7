// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "task_arena.h"

#include <thread>

namespace tbb {

void parallel_invoke(const auto& first, const auto& second) {
  if (this_task_arena::max_concurrency() < 2) {
    first();
    second();
    return;
  }
  const std::jthread other(second);
  first();
}

}  // namespace tbb
