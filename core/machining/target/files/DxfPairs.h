// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"

#include <cstdint>
#include <string_view>

namespace handwheel {

// A group of a DXF file. It consists of a code and a value on the next line.
struct DxfPair {
  int code = 0;
  std::string_view value;  // without surrounding blanks
  std::uint64_t line = 0;  // line number of the value, from 1

  // Returns the value as a number. Errors: NumberMalformed and NumberNotFinite, with the line number.
  Result<double> number() const;
  int whole() const;  // 0: the value is not an integer
  bool is(int wanted, std::string_view text) const { return code == wanted && value == text; }
};

// Reads the groups of a DXF file one after the other.
class DxfPairs {
 public:
  explicit DxfPairs(std::string_view bytes) : m_rest(bytes) {}

  // Reads the next group. Returns false at the end of the file. Errors: ElementMalformed if a code is not a number or
  // has no value.
  Result<bool> next(DxfPair& pair);
  std::size_t left() const { return m_rest.size(); }  // number of unread bytes

 private:
  std::string_view takeLine();

  std::string_view m_rest;
  std::uint64_t m_line = 0;
};

}  // namespace handwheel
