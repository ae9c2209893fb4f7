// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramScanner.h"
#include "machining/program/ProgramSetup.h"
#include "machining/program/ProgramVariables.h"

namespace handwheel {

// Evaluates the values in a line of a program. The values are numbers, variables, and expressions in square brackets.
//
// LinuxCNC and Fanuc share most operators and functions; angles are in degrees. The precedence, from the strongest, is
// **, then * / MOD, then + -, then EQ NE GT GE LT LE, then AND OR XOR, which are logical. In Fanuc, AND is as strong as
// *, OR and XOR are as strong as +, all three work on bits, and MOD has the sign of its left side. FIX and FUP round
// down and up in LinuxCNC, and towards and away from zero in Fanuc. EQ allows a difference of 1e-4 in LinuxCNC. The
// cost is linear in the text; brackets may be at most kDeepest deep. Expressions without a value, such as a division by
// zero, are refused (ProgramRefusal).
class ProgramExpression {
 public:
  static constexpr int kDeepest = 60;

  ProgramExpression(ProgramScanner& scanner, const ProgramVariables& variables, ProgramDialect dialect)
      : m_scanner(scanner), m_variables(variables), m_dialect(dialect) {}

  // Reads the value after a letter: a number, a #variable, a function or an [expression], with signs.
  ProgramValue value();
  // Reads an expression without brackets around it, up to the first character that cannot continue it.
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
