// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/CsvLine.h"

namespace handwheel {

std::string_view takeLine(std::string_view& text) {
  const std::size_t end = text.find('\n');
  std::string_view line = text.substr(0, end);
  text.remove_prefix(end == text.npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

void splitCsvLine(std::string_view line, std::size_t most, std::vector<std::string>& fields) {
  fields.clear();
  bool isQuoted = false;
  std::string field;
  const auto add = [&] {
    const std::size_t first = field.find_first_not_of(' '), last = field.find_last_not_of(' ');
    fields.push_back(first == field.npos ? std::string() : field.substr(first, last - first + 1));
    field.clear();
  };
  for (std::size_t i = 0; i < line.size() && fields.size() < most; ++i) {
    if (line[i] == '"' && isQuoted && i + 1 < line.size() && line[i + 1] == '"')
      field += line[++i];
    else if (line[i] == '"')
      isQuoted = !isQuoted;
    else if (line[i] == ',' && !isQuoted)
      add();
    else
      field += line[i];
  }
  if (fields.size() < most) add();
}

}  // namespace handwheel
