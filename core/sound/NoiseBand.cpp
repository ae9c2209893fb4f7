// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sound/NoiseBand.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

void NoiseBand::setBand(double centre, double quality) noexcept {
  const double frequency = std::clamp(centre, 1e-4 * m_rate, 0.45 * m_rate);
  m_damping = 1.0 / std::max(0.1, quality);
  m_gain = std::tan(std::numbers::pi * frequency / m_rate);
  m_divisor = 1.0 / (1.0 + m_gain * (m_gain + m_damping));
  // The bilinear transform maps the response of the analogue filter, damping · s / (s² + damping · s + 1), so its share
  // of white noise is that of 1 / (1 + Q² (x - 1/x)²), x = tan(w/2) / gain, over all w: by the residue at the poles,
  // gain · damping / (1 + gain · damping + gain²).
  const double share = m_gain * m_damping * m_divisor;
  m_scale = std::sqrt(3.0 / share);  // uniform noise within ±1 has a variance of a third
}

double NoiseBand::white() noexcept {  // Marsaglia, "Xorshift RNGs" (2003)
  m_random ^= m_random << 13;
  m_random ^= m_random >> 17;
  m_random ^= m_random << 5;
  return static_cast<double>(static_cast<std::int32_t>(m_random)) / 2147483648.0;
}

double NoiseBand::next() noexcept {
  const double high = white() - m_low;
  const double band = m_divisor * (m_gain * high + m_band);
  const double low = m_low + m_gain * band;
  m_band = 2.0 * band - m_band;
  m_low = 2.0 * low - m_low;
  return m_scale * m_damping * band;
}

}  // namespace handwheel
