// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace handwheel {

// A lock-free triple buffer that passes the newest value between two threads. One thread writes and one reads; older
// values are overwritten unread. Reading and writing never wait, lock or allocate, and a value is never seen half
// written.
template <class T>
class TripleBuffer {
 public:
  explicit TripleBuffer(const T& initial = {}) { m_slots.fill(initial); }
  TripleBuffer(const TripleBuffer&) = delete;
  TripleBuffer& operator=(const TripleBuffer&) = delete;

  // Sets the value. Must be called on the writing thread.
  void write(const T& value) noexcept {
    m_slots[m_writing] = value;
    m_writing = m_shared.exchange(m_writing | kIsNew, std::memory_order_acq_rel) & kIndex;
  }

  // Returns the value written last. Must be called on the reading thread. The reference is valid until the next call.
  const T& read() noexcept {
    if (m_shared.load(std::memory_order_relaxed) & kIsNew)
      m_reading = m_shared.exchange(m_reading, std::memory_order_acq_rel) & kIndex;
    return m_slots[m_reading];
  }

 private:
  static constexpr std::uint32_t kIndex = 3;
  static constexpr std::uint32_t kIsNew = 4;
  std::array<T, 3> m_slots;
  std::uint32_t m_writing = 0;
  std::uint32_t m_reading = 1;
  std::atomic<std::uint32_t> m_shared{2};
};

}  // namespace handwheel
