// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/program/RobotProgram.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The data that KRL declares: positions, "DECL E6POS XP1={X 1,…}", and signals. Names are not case-sensitive.
class KrlData {
 public:
  // text: the files of data beside a program. The text must outlive this object.
  explicit KrlData(std::string_view text);

  // Reads the declaration in a line, if it is one. A position that two declarations give different numbers has none any
  // more.
  void read(std::string_view line);
  // Returns the braces of a position with their contents; nothing if there is no such position.
  std::optional<std::string_view> valueOf(std::string_view name) const;
  // Returns true if an assignment to the name may switch an output: it is a signal, or declared nowhere.
  bool maySwitch(std::string_view name) const;
  // Returns the lines that declare what these lines name and only the file of the program's own data declares: its
  // declarations, then the assignments of their values, which programs may not declare.
  std::vector<ProgramLine> neededBy(const std::vector<ProgramLine>& lines) const;

  // Returns true for the name of the home position that KUKA's dialogues use.
  static bool isHome(std::string_view name);

 private:
  // A declaration of the program's own data, without its values.
  struct Own {
    std::string declaration;
    std::vector<std::string> values;
  };
  void readOwn(std::string_view line);

  std::map<std::string, std::string> m_values;  // by names in lower case
  std::set<std::string> m_declared, m_signals;  // likewise
  std::map<std::string, Own> m_own;             // likewise
};

}  // namespace handwheel
