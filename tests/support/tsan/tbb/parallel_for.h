// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "blocked_range.h"
#include "task_arena.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace tbb {

template <class Index>
requires std::is_integral_v<Index>
void parallel_for(Index begin, Index end, const auto& body) {
  std::atomic<Index> next = begin;
  const auto work = [&] {
    for (Index i = next++; i < end; i = next++) body(i);
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < this_task_arena::max_concurrency(); ++i) threads.emplace_back(work);
  work();
}

template <class Value>
void parallel_for(const blocked_range<Value>& range, const auto& body) {
  const Value grain = range.grainsize();
  const Value blocks = (range.end() - range.begin() + grain - 1) / grain;
  parallel_for(Value{0}, blocks, [&](Value block) {
    const Value begin = range.begin() + block * grain;
    body(blocked_range<Value>(begin, std::min(range.end(), begin + grain), grain));
  });
}

}  // namespace tbb
