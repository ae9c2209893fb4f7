// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>

namespace handwheel {

// The newest value from one thread to one other, without locks and without either ever waiting: three slots, of which
// each side owns one and the third changes hands. Values that nobody took in time are lost; no value is ever half of
// another.
template <class T>
class Latest {
 public:
  // The publishing thread.
  void publish(const T& value) noexcept {
    m_slots[m_back] = value;
    m_back = m_middle.exchange(m_back | kFresh, std::memory_order_acq_rel) & kIndex;
  }

  // The taking thread. The value stays until its next call.
  const T& take() noexcept {
    if (m_middle.load(std::memory_order_relaxed) & kFresh) {
      m_front = m_middle.exchange(m_front, std::memory_order_acq_rel) & kIndex;
    }
    return m_slots[m_front];
  }

 private:
  static constexpr unsigned kIndex = 3, kFresh = 4;
  static_assert(std::atomic<unsigned>::is_always_lock_free);

  std::array<T, 3> m_slots{};
  unsigned m_back = 0;
  unsigned m_front = 1;
  std::atomic<unsigned> m_middle{2};
};

}  // namespace handwheel
