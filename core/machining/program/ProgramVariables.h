// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramErrors.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace handwheel {

// The value of a variable. A vacant value counts as 0 in arithmetic; a word with a vacant value is ignored (Fanuc).
struct ProgramValue {
  double number = 0.0;
  bool isVacant = false;
};

// The variables of a lathe program: #number and #<name>. The first numbers, from 1, and names without a leading
// underscore belong to the current subprogram. All other variables belong to the program.
class ProgramVariables {
 public:
  static constexpr int kLargest = 99'999;
  static constexpr std::size_t kMost = 100'000;  // limit for numbers, and for names
  using System = std::function<std::optional<ProgramValue>(int)>;
  using NamedSystem = std::function<std::optional<double>(const std::string&)>;

  // locals: the count of numbers, from 1, that belong to the current subprogram. isVacant: true if a variable that was
  // never set is vacant, false if it is 0.
  ProgramVariables(int locals, bool isVacant) : m_localCount(locals), m_isVacant(isVacant), m_frames(1) {}
  // Sets the functions that look up the variables of the machine. They are called before other variables are searched.
  void setSystem(System numbers, NamedSystem names);

  ProgramValue get(int number) const;
  void set(int number, ProgramValue value, const SourceLocation& location);
  std::optional<double> get(const std::string& name) const;
  void set(const std::string& name, double value, const SourceLocation& location);

  // Enter a subprogram with these values of #1, #2, …, and leave it.
  void enter(const std::vector<ProgramValue>& arguments);
  void leave();

 private:
  struct Frame {
    std::unordered_map<int, ProgramValue> numbers;
    std::map<std::string, double> names;
  };

  int m_localCount;
  bool m_isVacant;
  System m_system;
  NamedSystem m_namedSystem;
  std::unordered_map<int, ProgramValue> m_global;
  std::map<std::string, double> m_globalNames;
  std::vector<Frame> m_frames;
};

}  // namespace handwheel
