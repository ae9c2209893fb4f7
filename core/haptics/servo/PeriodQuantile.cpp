// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/servo/PeriodQuantile.h"

#include <algorithm>

namespace handwheel {

void PeriodQuantile::add(double seconds) {
  const double last = static_cast<double>(m_bins.size() - 1);
  const double position = std::clamp(seconds / m_resolution, 0.0, last);
  Bin& bin = m_bins[static_cast<std::size_t>(position)];
  ++bin.count;
  bin.longest = std::max(bin.longest, seconds);
  if (++m_count == kWindow) closeWindow();
}

void PeriodQuantile::closeWindow() {
  const std::uint32_t usual = kWindow - kWindow / 100;
  std::uint32_t below = 0;
  for (const Bin& bin : m_bins) {
    below += bin.count;
    if (below < usual) continue;
    m_value = bin.longest;
    break;
  }
  m_bins.fill({});
  m_count = 0;
}

}  // namespace handwheel
