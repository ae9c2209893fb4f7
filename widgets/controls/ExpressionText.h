// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "base/Expression.h"

namespace handwheel {

// Why an expression has no value, and where, as one sentence: "There is no unit “foo” (character 4)."
QString expressionProblem(const ExpressionError& error);

}  // namespace handwheel
