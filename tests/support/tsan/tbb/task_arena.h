// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

// Replaces oneTBB in builds with ThreadSanitizer (preset tsan). Debian's libtbb is not instrumented, so the sanitizer
// cannot see how it orders the work of threads and reports each task as a race. Suppressions for these reports would
// also hide races inside the program's own tasks. This implementation runs the tasks on plain threads, which the
// sanitizer can follow.

namespace tbb {

namespace this_task_arena {

inline thread_local int concurrency = 4;  // may exceed the number of cores, so that threads overlap

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
