// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

namespace handwheel {

// Returns true if a shared object has only one owner left. The owner may then write to it. The function is for
// copy-on-write by one thread, while other threads release snapshots. If the result is true, all reads of the object by
// those threads have happened before.
template <class T>
bool isSoleOwner(const std::shared_ptr<T>& p) {
  if (p.use_count() != 1) return false;
#ifdef __SANITIZE_THREAD__
  // ThreadSanitizer does not support fences. Taking a reference has the same effect on it.
  const std::shared_ptr<T> acquired = p;
#else
  std::atomic_thread_fence(std::memory_order_acquire);
#endif
  return true;
}

}  // namespace handwheel
