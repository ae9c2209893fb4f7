// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

namespace handwheel {

// A hash of data that is the same on every machine. It is not cryptographic, and no protection against forged data.
class Fingerprint {
 public:
  void add(std::uint64_t value) {
    constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15u;  // 2^64 divided by the golden ratio; its bits look random
    m_value = (m_value ^ value) * kOdd;
    m_value ^= m_value >> 32;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void add(std::string_view text) {
    add(static_cast<std::uint64_t>(text.size()));
    for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
  }
  std::uint64_t value() const { return m_value; }

 private:
  std::uint64_t m_value = 0x6A09E667F3BCC908u;  // the fractional bits of the square root of two
};

}  // namespace handwheel
