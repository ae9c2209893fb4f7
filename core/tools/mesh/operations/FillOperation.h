// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/holes/HoleFiller.h"

namespace handwheel {

// Returns the description of filling one hole.
const Operation& fillOperation();

// Returns the parameters of all operations that fill holes; their Parameter::bundle is "FILL".
std::vector<Parameter> fillParameters();
// Returns the parameter "numbers", the number type to which coordinates are rounded; the default is that of the file.
Parameter numbersParameter();

// Convert the fill options from and to the values of any operation that has fillParameters(). The default number type
// is double; the loops that stay open are not among the values.
FillOptions fillOptionsOf(const OperationValues& values);
void setFillOptions(OperationValues& values, const FillOptions& options);
// Returns the values for filling one hole, which include bridges.
OperationValues valuesOf(const FillOptions& options);

std::optional<NumberType> numbersOf(const OperationValues& values);
void setNumbers(OperationValues& values, NumberType numbers);

}  // namespace handwheel
