// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/ContainerLayout.h"

#include <zlib.h>
#include <algorithm>

namespace handwheel::layout {

bool isBlobName(std::string_view name) {
  constexpr std::size_t kLongest = 200;
  if (name.empty() || name.size() > kLongest || isManifestName(name)) return false;
  const auto isBad = [](char c) { return c < ' ' || c > '~' || c == '\\' || c == ':'; };
  if (std::any_of(name.begin(), name.end(), isBad)) return false;
  for (;;) {
    const std::size_t slash = std::min(name.find('/'), name.size());
    const std::string_view part = name.substr(0, slash);
    if (part.empty() || part == "." || part == "..") return false;
    if (slash == name.size()) return true;
    name.remove_prefix(slash + 1);
  }
}

std::string checksumText(std::string_view bytes) {
  auto sum = crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size());
  std::string digits(8, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, sum >>= 4) *digit = "0123456789abcdef"[sum & 15];
  return digits;
}

}  // namespace handwheel::layout
