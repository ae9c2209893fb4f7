// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramScanner.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ProgramVariables.h"

namespace handwheel {

// Evaluates the values in a line of a program. They are numbers, variables, and expressions in square brackets.
//
// LinuxCNC and Fanuc share most operators and functions; angles are degrees. From the strongest: **, then * / MOD, then
// + -, then EQ NE GT GE LT LE, then AND OR XOR, which are logical. In Fanuc AND is as strong as *, OR and XOR are as
// strong as +, all three work on bits, and MOD has the sign of its left side. FIX and FUP round down and up in
// LinuxCNC, towards and away from zero in Fanuc. Equal (EQ) is what differs by less than 1e-4 in LinuxCNC. Cost: linear
// in the text; the depth of brackets is limited. Refuses (ProgramRefusal) what has no value, such as a division by
// zero.
class ProgramExpression {
 public:
  static constexpr int kDeepest = 60;

  ProgramExpression(ProgramScanner& scanner, const ProgramVariables& variables, ProgramDialect dialect)
      : m_scanner(scanner), m_variables(variables), m_dialect(dialect) {}

  // A value as it stands after a letter: a number, #variable, function or [expression], with signs.
  ProgramValue value();
  // An expression without brackets around it, to the end of what belongs to it.
  ProgramValue expression() { return binary(0); }
  // The number of a variable after its #.
  int variableNumber();

 private:
  ProgramValue binary(int least);
  ProgramValue variable();
  double function(const std::string& name, const ProgramPlace& place);
  double bracketed();
  double finite(double value, const ProgramPlace& place, const std::string& what) const;
  void enter();

  ProgramScanner& m_scanner;
  const ProgramVariables& m_variables;
  ProgramDialect m_dialect;
  int m_depth = 0;
};

}  // namespace handwheel
