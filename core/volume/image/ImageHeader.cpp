// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageHeader.h"

#include "base/NumberText.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace handwheel::imageHeader {
namespace {

constexpr std::string_view kHeaderBlanks = " \t\r\f\v";

}  // namespace

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kHeaderBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kHeaderBlanks) - first + 1);
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  constexpr std::size_t kMost = 100;
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kHeaderBlanks); at != std::string_view::npos && words.size() < kMost;) {
    const std::size_t end = std::min(text.find_first_of(kHeaderBlanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kHeaderBlanks, end);
  }
  return words;
}

std::optional<std::vector<double>> numbersOf(std::string_view text, std::size_t count) {
  const std::vector<std::string_view> words = wordsOf(text);
  if (words.size() != count) return {};
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    double number = 0.0;
    ErrorCode why;
    if (!parseDecimal(word, number, why) || !std::isfinite(number)) return {};
    numbers.push_back(number);
  }
  return numbers;
}

std::optional<std::size_t> countOf(std::string_view word) {
  constexpr std::size_t kLargest = std::size_t{1} << 53;
  std::size_t count = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), count);
  if (error != std::errc() || end != word.data() + word.size() || count > kLargest) return {};
  return count;
}

std::string lowered(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

Error malformed(std::string_view field, const char* why) {
  return {ErrorCode::ElementMalformed, {std::string(field), why}, {}, {}};
}

}  // namespace handwheel::imageHeader
