// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace handwheel::test {

// The power spectrum of a signal under a Hann window. It is computed by an FFT of radix 2 (Cooley and Tukey).
class Spectrum {
 public:
  Spectrum(const std::vector<double>& signal, double rate) {
    std::size_t n = 1;
    while (2 * n <= signal.size()) n *= 2;
    m_width = rate / static_cast<double>(n);
    std::vector<std::complex<double>> x(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double window =
          0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
      x[i] = window * signal[i];
    }
    transform(x);
    m_power.resize(n / 2);
    for (std::size_t i = 0; i < n / 2; ++i) m_power[i] = std::norm(x[i]);
  }

  double binWidth() const { return m_width; }  // Hz

  double power(double from, double to) const {  // Hz
    double sum = 0.0;
    for (std::size_t i = 1; i < m_power.size(); ++i) {
      const double frequency = m_width * static_cast<double>(i);
      if (frequency >= from && frequency < to) sum += m_power[i];
    }
    return sum;
  }

  double peak(double from, double to) const {
    double best = -1.0, frequencyOfPeak = 0.0;
    for (std::size_t i = 1; i < m_power.size(); ++i) {
      const double frequency = m_width * static_cast<double>(i);
      if (frequency < from || frequency >= to || m_power[i] <= best) continue;
      best = m_power[i];
      frequencyOfPeak = frequency;
    }
    return frequencyOfPeak;
  }

  // Returns the frequency that halves the power.
  double median() const {
    const double all = power(0.0, 1e9);
    double sum = 0.0;
    for (std::size_t i = 1; i < m_power.size(); ++i) {
      sum += m_power[i];
      if (sum >= 0.5 * all) return m_width * static_cast<double>(i);
    }
    return 0.0;
  }

 private:
  static void transform(std::vector<std::complex<double>>& x) {
    const std::size_t n = x.size();
    if (n < 2) return;
    std::vector<std::complex<double>> even(n / 2), odd(n / 2);
    for (std::size_t i = 0; i < n / 2; ++i) {
      even[i] = x[2 * i];
      odd[i] = x[2 * i + 1];
    }
    transform(even);
    transform(odd);
    for (std::size_t i = 0; i < n / 2; ++i) {
      const auto turned =
          std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n)) * odd[i];
      x[i] = even[i] + turned;
      x[i + n / 2] = even[i] - turned;
    }
  }

  double m_width;
  std::vector<double> m_power;
};

inline double rootMeanSquare(const std::vector<double>& signal) {
  double sum = 0.0;
  for (double s : signal) sum += s * s;
  return std::sqrt(sum / static_cast<double>(signal.size()));
}

}  // namespace handwheel::test
