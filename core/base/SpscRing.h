// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace handwheel {

// A bounded lock-free FIFO queue from one thread to another. Reading and writing never wait, lock or allocate. When the
// queue is full, the newest value is dropped and counted, because the writer is a real-time thread that must not wait.
template <class T>
class SpscRing {
 public:
  // Creates an empty queue. The capacity is rounded up to a power of two.
  explicit SpscRing(std::size_t capacity) : m_values(std::bit_ceil(capacity)), m_mask(m_values.size() - 1) {}
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;

  // Appends a value. Returns false if the queue is full. Must be called on the writing thread.
  bool push(const T& value) noexcept {
    const std::uint64_t at = m_written.load(std::memory_order_relaxed);
    if (at - m_read.load(std::memory_order_acquire) > m_mask) {
      m_dropped.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    m_values[at & m_mask] = value;
    m_written.store(at + 1, std::memory_order_release);
    return true;
  }

  // Takes the oldest value. Returns false if the queue is empty. Must be called on the reading thread.
  bool pop(T& value) noexcept {
    const std::uint64_t at = m_read.load(std::memory_order_relaxed);
    if (at == m_written.load(std::memory_order_acquire)) return false;
    value = m_values[at & m_mask];
    m_read.store(at + 1, std::memory_order_release);
    return true;
  }

  std::size_t capacity() const { return m_values.size(); }
  std::uint64_t dropped() const { return m_dropped.load(std::memory_order_relaxed); }  // may be called on any thread

 private:
  static constexpr std::size_t kCacheLine = 64;  // separate lines for the counters prevent false sharing
  alignas(kCacheLine) std::atomic<std::uint64_t> m_written{0};
  std::atomic<std::uint64_t> m_dropped{0};
  std::vector<T> m_values;
  const std::uint64_t m_mask;
  alignas(kCacheLine) std::atomic<std::uint64_t> m_read{0};
};

}  // namespace handwheel
