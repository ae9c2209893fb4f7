// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

// Stands in for oneTBB under ThreadSanitizer (preset tsan). Debian's libtbb is not instrumented: what it orders between
// threads goes unseen, every handed-over task is reported as a race, and a suppression wide enough to silence that
// would silence the races inside our tasks as well. Here the same calls run on plain threads, which the sanitizer
// understands.

namespace tbb {

namespace this_task_arena {

inline thread_local int concurrency = 4;  // more than the machine may have: threads must overlap

inline int max_concurrency() {
  return concurrency;
}

}  // namespace this_task_arena

class task_arena {
 public:
  explicit task_arena(int concurrency) : m_concurrency(concurrency) {}

  void execute(auto&& work) {
    const int before = std::exchange(this_task_arena::concurrency, m_concurrency);
    work();
    this_task_arena::concurrency = before;
  }

 private:
  int m_concurrency;
};

}  // namespace tbb
