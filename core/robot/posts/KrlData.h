// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace handwheel {

// Positions that KRL declarations name: "DECL E6POS XP1={X 1,…}". Names are not case-sensitive.
class KrlData {
 public:
  // text: the files of data beside a program. The text must outlive this object.
  explicit KrlData(std::string_view text);

  // Reads the declaration in a line, if it is one of a position. A name that two declarations have with different
  // numbers has none any more.
  void read(std::string_view line);
  // Returns the braces of a position with their contents; nothing if there is no such position.
  std::optional<std::string_view> valueOf(std::string_view name) const;

  // Returns true for the name of the home position that KUKA's dialogues use.
  static bool isHome(std::string_view name);

 private:
  std::map<std::string, std::string> m_values;  // by names in lower case
};

}  // namespace handwheel
