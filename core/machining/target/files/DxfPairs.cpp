// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/DxfPairs.h"

#include "base/NumberText.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace handwheel {

namespace {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n\v\f";
  const std::size_t first = text.find_first_not_of(kBlank);
  return first == text.npos ? std::string_view() : text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

Error aboutWord(ErrorCode code, std::string_view word, std::uint64_t line) {
  constexpr std::size_t kShown = 40;
  return {code, {std::string(word.substr(0, kShown))}, InputPosition::line(line), {}};
}

}  // namespace

Result<double> DxfPair::number() const {
  double parsed = 0.0;
  ErrorCode why = ErrorCode::NumberMalformed;
  if (!parseDecimal(value, parsed, why)) return aboutWord(why, value, line);
  if (!std::isfinite(parsed)) return aboutWord(ErrorCode::NumberNotFinite, value, line);
  return parsed;
}

int DxfPair::whole() const {
  int parsed = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), parsed);
  return error == std::errc() ? parsed : 0;
}

std::string_view DxfPairs::takeLine() {
  const std::size_t end = std::min(m_rest.find('\n'), m_rest.size());
  const std::string_view line = m_rest.substr(0, end);
  m_rest.remove_prefix(std::min(end + 1, m_rest.size()));
  ++m_line;
  return trimmed(line);
}

Result<bool> DxfPairs::next(DxfPair& pair) {
  const std::string_view code = takeLine();
  if (code.empty() && m_rest.empty()) return false;
  const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), pair.code);
  if (error != std::errc() || end != code.data() + code.size()) {
    return Error{ErrorCode::ElementMalformed, {"group", "its code is not a number"}, InputPosition::line(m_line), {}};
  }
  if (m_rest.empty())
    return Error{ErrorCode::ElementMalformed, {"group", "it has no value"}, InputPosition::line(m_line), {}};
  pair.value = takeLine();
  pair.line = m_line;
  return true;
}

}  // namespace handwheel
