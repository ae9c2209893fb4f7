// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace handwheel {

// Histogram of times with bins of equal width. The last bin also counts all longer times, the first bin the negative
// ones. One thread may add times, and any thread may read the histogram, without locks.
class TimingHistogram {
 public:
  static constexpr std::size_t kBins = 256;
  using Counts = std::array<std::uint64_t, kBins>;

  explicit TimingHistogram(double binSeconds) : m_binSeconds(binSeconds) {}

  void add(double seconds) noexcept;
  Counts counts() const;
  double binSeconds() const { return m_binSeconds; }
  // Returns the upper end, s, of the bin that contains the quantile for a fraction, 0 to 1. Returns 0 if there are no
  // values.
  double quantile(double share) const;

 private:
  const double m_binSeconds;
  std::array<std::atomic<std::uint64_t>, kBins> m_counts{};
};

}  // namespace handwheel
