// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/deviation/MeshDeviation.h"

#include <algorithm>

namespace handwheel {

std::vector<double> sharesWithin(const SurfaceDeviation& deviation, double range, std::size_t bins) {
  std::vector<double> shares(bins, 0.0);
  const std::vector<double>& fine = deviation.histogram;
  const double low = deviation.lowest.distance, width = deviation.highest.distance - low;
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const double value = low + width * (static_cast<double>(i) + 0.5) / static_cast<double>(fine.size());
    const double at = std::clamp(0.5 + 0.5 * value / range, 0.0, 1.0) * static_cast<double>(bins);
    shares[std::min(static_cast<std::size_t>(at), bins - 1)] += fine[i];
  }
  return shares;
}

}  // namespace handwheel
