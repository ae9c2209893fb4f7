// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <cstdint>
#include <string_view>

namespace handwheel {

// A group of a DXF file: a code and a value on the next line.
struct DxfPair {
  int code = 0;
  std::string_view value;  // without blanks around it
  std::uint64_t line = 0;  // line of the value, from 1

  // Errors: NumberMalformed, NumberNotFinite, with the line.
  Result<double> number() const;
  int whole() const;  // 0 if it is no integer
  bool is(int wanted, std::string_view text) const { return code == wanted && value == text; }
};

// Reads the groups of a DXF file one after the other.
class DxfPairs {
 public:
  explicit DxfPairs(std::string_view bytes) : m_rest(bytes) {}

  // Returns false at the end. Errors: ElementMalformed if a code is no number, or has no value.
  Result<bool> next(DxfPair& pair);
  std::size_t left() const { return m_rest.size(); }  // bytes

 private:
  std::string_view takeLine();

  std::string_view m_rest;
  std::uint64_t m_line = 0;
};

}  // namespace handwheel
