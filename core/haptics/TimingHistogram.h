// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace handwheel {

// How often a time fell into which of the equal bins; the last bin holds all that is longer, the first what is below
// zero. One thread adds, any thread reads; no locks.
class TimingHistogram {
 public:
  static constexpr std::size_t kBins = 256;
  using Counts = std::array<std::uint64_t, kBins>;

  explicit TimingHistogram(double binSeconds) : m_binSeconds(binSeconds) {}

  void add(double seconds) noexcept;
  Counts counts() const;
  double binSeconds() const { return m_binSeconds; }
  // The upper end, s, of the bin that holds the value of which the share (0 to 1) is not above; 0 without values.
  double quantile(double share) const;

 private:
  const double m_binSeconds;
  std::array<std::atomic<std::uint64_t>, kBins> m_counts{};
};

}  // namespace handwheel
