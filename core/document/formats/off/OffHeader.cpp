// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/off/OffHeader.h"

#include "document/formats/MeshTextValues.h"

namespace handwheel {

std::optional<OffKeyword> parseOffKeyword(std::string_view word) {
  OffKeyword keyword;
  std::string_view rest = word;
  const auto take = [&rest](std::string_view prefix) {
    if (!rest.starts_with(prefix)) return false;
    rest.remove_prefix(prefix.size());
    return true;
  };
  for (bool isAttribute = true; isAttribute;) {
    isAttribute = false;
    if (!keyword.texture) isAttribute = keyword.texture = take("ST");
    if (!isAttribute && !keyword.colour) isAttribute = keyword.colour = take("C");
    if (!isAttribute && !keyword.normal) isAttribute = keyword.normal = take("N");
  }
  const bool four = take("4"), many = take("n");
  keyword.otherDimension = four || many;
  if (!take("OFF") && !take("off")) return {};
  if (rest.find_first_not_of("0123456789") != std::string_view::npos) return {};
  keyword.length = word.size() - rest.size();
  return keyword;
}

bool beginsWithOffKeyword(std::string_view bytes) {
  constexpr std::size_t kProbe = 64 * 1024;
  TextScanner scanner(bytes.substr(0, kProbe), {'#', -1});
  return parseOffKeyword(scanner.wordOnAnyLine()).has_value();
}

}  // namespace handwheel
