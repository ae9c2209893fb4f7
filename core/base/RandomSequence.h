// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace handwheel {

// A generator of pseudo-random numbers, reproducible on every platform from its seed. It is SplitMix64 (Steele, Lea and
// Flood 2014, Fast splittable pseudorandom number generators). It is a value type, and not suitable for secrets.
class RandomSequence {
 public:
  explicit RandomSequence(std::uint64_t seed) : m_state(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (m_state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  double share() { return static_cast<double>(next() >> 11) * 0x1p-53; }  // 0 ≤ result < 1
  double between(double low, double high) { return low + (high - low) * share(); }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(share() * static_cast<double>(count)); }

 private:
  std::uint64_t m_state;
};

}  // namespace handwheel
