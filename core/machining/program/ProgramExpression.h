// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramScanner.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ProgramVariables.h"

namespace handwheel {

// Evaluates the values in a line of a program. They are numbers, variables, and expressions in square brackets.
//
// LinuxCNC and Fanuc share most operators and functions; angles are degrees. Precedence, from the strongest: **, then *
// / MOD, then + -, then EQ NE GT GE LT LE, then AND OR XOR, which are logical. In Fanuc AND is as strong as *, OR and
// XOR are as strong as +, all three work on bits, and MOD has the sign of its left side. FIX and FUP round down and up
// in LinuxCNC, towards and away from zero in Fanuc. EQ allows a difference of 1e-4 in LinuxCNC. Cost: linear in the
// text; the depth of brackets is limited. Refuses (ProgramRefusal) expressions without a value, such as a division by
// zero.
class ProgramExpression {
 public:
  static constexpr int kDeepest = 60;

  ProgramExpression(ProgramScanner& scanner, const ProgramVariables& variables, ProgramDialect dialect)
      : m_scanner(scanner), m_variables(variables), m_dialect(dialect) {}

  // Reads a value after a letter: a number, #variable, function or [expression], with signs.
  ProgramValue value();
  // Reads an expression without brackets around it, as far as it goes.
  ProgramValue expression() { return binary(0); }
  // Reads the number of a variable after its #.
  int variableNumber();

 private:
  ProgramValue binary(int least);
  ProgramValue variable();
  double function(const std::string& name, const SourceLocation& location);
  double bracketed();
  double finite(double value, const SourceLocation& location, const std::string& what) const;
  void enter();

  ProgramScanner& m_scanner;
  const ProgramVariables& m_variables;
  ProgramDialect m_dialect;
  int m_depth = 0;
};

}  // namespace handwheel
