// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

// Cancels work at its n-th allocation. Such points are the same in every run, unlike those of a clock. The header
// replaces operator new, so only one source file of a program may include it.
namespace handwheel::test {

// Counts the allocations of the current thread during its lifetime, and cancels its job at one of them.
class CancelPoint {
 public:
  static constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();

  explicit CancelPoint(std::size_t at = kNever) : m_at(at) { current() = this; }
  ~CancelPoint() { current() = nullptr; }
  CancelPoint(const CancelPoint&) = delete;
  CancelPoint& operator=(const CancelPoint&) = delete;

  Progress progress() { return Progress(m_job); }
  bool isReached() const { return m_job.cancelled; }
  std::size_t allocations() const { return m_count; }
  std::size_t allocationsAfter() const { return isReached() ? m_count - m_at : 0; }
  // Returns true if the fraction of progress, read at each allocation, stayed from 0 to 1 and never decreased.
  bool isMonotone() const { return m_isMonotone; }

  static void allocated() {
    if (CancelPoint* point = current()) point->count();
  }

 private:
  static CancelPoint*& current() {
    static thread_local CancelPoint* point = nullptr;
    return point;
  }

  void count() {
    if (++m_count == m_at) m_job.cancelled = true;
    const double fraction = m_job.fraction;
    m_isMonotone = m_isMonotone && fraction >= m_last - 1e-12 && fraction <= 1.0 + 1e-12;  // parts are rounded
    m_last = fraction;
  }

  JobState m_job;
  std::size_t m_at;
  std::size_t m_count = 0;
  double m_last = 0.0;
  bool m_isMonotone = true;
};

// Returns cancel points for work with this number of allocations. They are the first allocations, at which passes
// allocate their arrays, and some spread over the rest.
inline std::vector<std::size_t> cancelPoints(std::size_t allocations) {
  constexpr std::size_t kFirst = 10, kSpread = 3;
  std::vector<std::size_t> points;
  for (std::size_t n = 1; n <= std::min(kFirst, allocations); ++n) points.push_back(n);
  for (std::size_t i = 0; i < kSpread && allocations > kFirst; ++i) {
    points.push_back(kFirst + (allocations - kFirst) * (2 * i + 1) / (2 * kSpread));
  }
  return points;
}

}  // namespace handwheel::test

// The nothrow version is replaced, too: that of the sanitizers would not match the operator delete of this header.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  handwheel::test::CancelPoint::allocated();
  return std::malloc(size > 0 ? size : 1);
}
void* operator new(std::size_t size) {
  if (void* bytes = operator new(size, std::nothrow)) return bytes;
  throw std::bad_alloc();
}
void operator delete(void* bytes) noexcept {
  std::free(bytes);
}
void operator delete(void* bytes, std::size_t) noexcept {
  std::free(bytes);
}
