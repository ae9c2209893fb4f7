// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/ReaderAnswer.h"

#include <utility>

namespace handwheel {

std::optional<ReaderAnswer> answerOf(std::string bytes) {
  constexpr std::size_t kLongestReason = 200;  // bytes
  if (bytes.empty()) return {};
  const char kind = bytes.back();
  bytes.pop_back();
  switch (kind) {
    case static_cast<char>(ReaderAnswer::Kind::Content):
      return ReaderAnswer{ReaderAnswer::Kind::Content, std::move(bytes)};
    case static_cast<char>(ReaderAnswer::Kind::Reason):
      if (bytes.empty() || bytes.size() > kLongestReason) return {};
      return ReaderAnswer{ReaderAnswer::Kind::Reason, std::move(bytes)};
    case static_cast<char>(ReaderAnswer::Kind::OutOfMemory):
      return ReaderAnswer{ReaderAnswer::Kind::OutOfMemory, {}};
    default:
      return {};
  }
}

}  // namespace handwheel
