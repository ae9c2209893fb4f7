// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/TimingHistogram.h"

#include <numeric>

namespace handwheel {

void TimingHistogram::add(double seconds) noexcept {
  const double position = seconds / m_binSeconds;
  std::size_t bin = 0;
  if (position >= static_cast<double>(kBins - 1))
    bin = kBins - 1;
  else if (position > 0.0)  // not so for NaN
    bin = static_cast<std::size_t>(position);
  m_counts[bin].fetch_add(1, std::memory_order_relaxed);
}

TimingHistogram::Counts TimingHistogram::counts() const {
  Counts counts{};
  for (std::size_t i = 0; i < kBins; ++i) counts[i] = m_counts[i].load(std::memory_order_relaxed);
  return counts;
}

double TimingHistogram::quantile(double share) const {
  const Counts all = counts();
  const auto total = static_cast<double>(std::accumulate(all.begin(), all.end(), std::uint64_t{0}));
  double below = 0.0;
  for (std::size_t i = 0; i < kBins && total > 0.0; ++i) {
    below += static_cast<double>(all[i]);
    if (below >= share * total) return static_cast<double>(i + 1) * m_binSeconds;
  }
  return 0.0;
}

}  // namespace handwheel
