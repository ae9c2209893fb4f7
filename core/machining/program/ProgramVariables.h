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

// The assignment of a value to a numbered variable.
struct ProgramAssignment {
  int number = 0;
  ProgramValue value;
  SourceLocation location;
  std::string comment;  // comment that follows the value; it is the message of an alarm
};

// The variables of a lathe program: #number and #<name>. The first numbers, from 1, and names without a leading
// underscore belong to the current subprogram. All other variables belong to the program.
class ProgramVariables {
 public:
  static constexpr int kLargest = 99'999;
  static constexpr std::size_t kMost = 100'000;  // limit for numbers, and for names
  // The functions of the machine. They refuse (ProgramRefusal) what the machine cannot tell or take.
  struct System {
    std::function<std::optional<ProgramValue>(int, const SourceLocation&)> read;
    std::function<std::optional<double>(const std::string&)> readNamed;
    std::function<bool(const ProgramAssignment&)> write;  // false: the variable is none of the machine's
  };

  // locals: the count of numbers, from 1, that belong to the current subprogram. isVacant: true if a variable that was
  // never set is vacant, false if it is 0.
  ProgramVariables(int locals, bool isVacant) : m_localCount(locals), m_isVacant(isVacant), m_frames(1) {}
  // Sets the functions of the machine's variables. They are called before other variables are searched.
  void setSystem(System system) { m_system = std::move(system); }

  ProgramValue get(int number, const SourceLocation& location) const;
  void set(const ProgramAssignment& assignment);
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
  std::unordered_map<int, ProgramValue> m_global;
  std::map<std::string, double> m_globalNames;
  std::vector<Frame> m_frames;
};

}  // namespace handwheel
