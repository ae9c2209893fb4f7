// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "mesh/holes/HoleFiller.h"

namespace handwheel {

// The description of filling one hole.
const Operation& fillOperation();

// The parameters of all operations that fill holes: the bundle "FILL".
std::vector<Parameter> fillParameters();
// The parameter "numbers", the number type to which coordinates are rounded; without it that of the file.
Parameter numbersParameter();

// The options of a fill, of the values of any operation with its parameters. Numbers that are not given are double;
// what stays open is not among the values.
FillOptions fillOptionsOf(const OperationValues& values);
void setFillOptions(OperationValues& values, const FillOptions& options);
// The same of filling one hole, which has bridges, too.
OperationValues valuesOf(const FillOptions& options);

std::optional<NumberType> numbersOf(const OperationValues& values);
void setNumbers(OperationValues& values, NumberType numbers);

}  // namespace handwheel
