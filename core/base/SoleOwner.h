// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <memory>

namespace handwheel {

// Returns true if a shared object has only one owner left. Then it may be written. For copy-on-write by one thread,
// while snapshots are dropped on others; all their reads of the object happened before.
template <class T>
bool isSoleOwner(const std::shared_ptr<T>& p) {
  if (p.use_count() != 1) return false;
#ifdef __SANITIZE_THREAD__
  const std::shared_ptr<T> acquired = p;  // ThreadSanitizer knows no fences; taking a reference is one to it
#else
  std::atomic_thread_fence(std::memory_order_acquire);
#endif
  return true;
}

}  // namespace handwheel
