// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// White noise through a band-pass filter whose band may move at any time. Each run of the program gives the same
// samples. The filter is the trapezoidal state-variable filter, which stays stable while it is changed: Zavalishin,
// "The Art of VA Filter Design" (2012), chapter 4. An object may be used on any thread, but on one thread at a time; it
// takes no lock and allocates no memory.
class NoiseBand {
 public:
  explicit NoiseBand(double sampleRate) : m_rate(sampleRate) {}  // Hz

  // Sets the centre (Hz, below half of the sample rate) and the quality: centre divided by bandwidth.
  void setBand(double centre, double quality) noexcept;
  // Returns the next sample, with a standard deviation of 1.
  double next() noexcept;

 private:
  double white() noexcept;

  double m_rate;
  double m_damping = 1.0;  // 1 / quality
  double m_gain = 0.0;     // gain of the integrators
  double m_divisor = 1.0;
  double m_scale = 0.0;              // scale to a standard deviation of 1
  double m_band = 0.0, m_low = 0.0;  // states of the integrators
  std::uint32_t m_random = 0x2545F491u;
};

}  // namespace handwheel
