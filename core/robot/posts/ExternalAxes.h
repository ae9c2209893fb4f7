// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/program/RobotProgram.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace handwheel {

// Values of external axes by their names, mm or degrees.
using AxisValues = std::map<std::string, double, std::less<>>;

// The external axes of a program that is read. They may stand anywhere, and must not move.
class ExternalAxes {
 public:
  static constexpr double kNone = 9e8;  // from this value on there is no such axis, as 9E9 of RAPID
  static constexpr const char* kMoved = "an external axis moves, and only axes of the robot can";

  // Takes the values of the next motion, which may lack axes. Returns false if an axis moves, as one that is not at 0
  // may do if the first motion does not give it.
  bool take(const AxisValues& values, std::size_t line);
  const AxisValues& values() const { return m_values; }
  // Returns false if all values are 0, as they are where there are no such axes.
  bool isAnySet() const;

  // Appends a line with the values as "E1 1000,E2 0", if one is not 0.
  void addTo(std::vector<ProgramLine>& lines) const;
  void addTo(std::vector<ProgramLine>& lines, std::string text) const;

 private:
  AxisValues m_values;
  std::size_t m_line = 0;  // line of the first motion; 0: there was none
};

// Returns the text of the line of external axes before the motions of a program in this language; empty: there is none.
std::string externalAxesOf(const RobotProgram& program, std::string_view language);

}  // namespace handwheel
