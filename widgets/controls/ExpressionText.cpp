// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/ExpressionText.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct Text {
  Q_DECLARE_TR_FUNCTIONS(ExpressionText)
};

QString before(const QString& found, const QString& atEnd, const QString& elsewhere) {
  return found.isEmpty() ? atEnd : elsewhere.arg(found);
}

QString reason(const ExpressionError& error) {
  const QString found = QString::fromStdString(error.found);
  switch (error.kind) {
    case ExpressionError::Kind::Empty:
      return Text::tr("A number is missing");
    case ExpressionError::Kind::TooLong:
      return Text::tr("The expression is too long");
    case ExpressionError::Kind::TooDeep:
      return Text::tr("The brackets are nested too deeply");
    case ExpressionError::Kind::NumberMissing:
      return before(found, Text::tr("A number is missing at the end"), Text::tr("A number is missing before “%1”"));
    case ExpressionError::Kind::OperatorMissing:
      return Text::tr("An operator such as + or * is missing before “%1”").arg(found);
    case ExpressionError::Kind::BracketMissing:
      return before(found, Text::tr("A closing bracket is missing at the end"),
                    Text::tr("A closing bracket is missing before “%1”"));
    case ExpressionError::Kind::NumberMalformed:
      return Text::tr("“%1” is not a number").arg(found);
    case ExpressionError::Kind::CommaAmbiguous:
      return Text::tr("“%1” can be read in two ways; write it with a point, or without the comma").arg(found);
    case ExpressionError::Kind::NameUnknown:
      return Text::tr("“%1” is not a known unit").arg(found);
    case ExpressionError::Kind::UnlikeTerms:
      return Text::tr("Lengths, angles and plain numbers cannot be added to each other");
    case ExpressionError::Kind::WrongQuantity:
      return Text::tr("The result has the wrong unit");
    case ExpressionError::Kind::DivisionByZero:
      return Text::tr("Division by zero");
    case ExpressionError::Kind::TooLarge:
      return Text::tr("The result is too large");
  }
  return {};
}

}  // namespace

QString expressionProblem(const ExpressionError& error) {
  return Text::tr("%1 (character %2).").arg(reason(error)).arg(error.column);
}

}  // namespace handwheel
