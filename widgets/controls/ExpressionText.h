// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "base/Expression.h"

namespace handwheel {

// Describes the error of an expression with its position, in one sentence. Example: "There is no unit “foo” (character
// 4)."
QString expressionProblem(const ExpressionError& error);

}  // namespace handwheel
