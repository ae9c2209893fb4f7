// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/posts/KrlData.h"

#include "robot/posts/PostText.h"

namespace handwheel {

KrlData::KrlData(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    read(line.substr(0, line.find(';')));
  }
}

void KrlData::read(std::string_view text) {
  LineReader line(text, 0);
  bool isWord = true;
  while (isWord) isWord = line.takeWord("DECL") || line.takeWord("GLOBAL") || line.takeWord("CONST");
  bool isPosition = false;
  for (const char* const type : {"E6AXIS", "AXIS", "E6POS", "POS", "FRAME"})
    isPosition = isPosition || line.takeWord(type);
  const std::string name = lowerCase(std::string(line.name()));
  if (!isPosition || name.empty() || !line.take("=")) return;
  line.skipSpace();
  const std::size_t end = line.rest().find('}');
  if (!line.rest().starts_with('{') || end == std::string_view::npos) return;
  const std::string value(line.rest().substr(0, end + 1));
  const auto [known, isNew] = m_values.emplace(name, value);
  if (!isNew && known->second != value) known->second.clear();
}

std::optional<std::string_view> KrlData::valueOf(std::string_view name) const {
  const auto found = m_values.find(lowerCase(std::string(name)));
  if (found == m_values.end() || found->second.empty()) return std::nullopt;
  return found->second;
}

bool KrlData::isHome(std::string_view name) {
  const std::string lower = lowerCase(std::string(name));
  return lower == "xhome" || lower == "home";
}

}  // namespace handwheel
