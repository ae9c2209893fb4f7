// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"

namespace handwheel {

// Parameters of operations that place objects.

// Returns a text parameter without a default.
Parameter wordParameter(const char* id, const char* word, std::string meaning);
// Returns a parameter of three numbers between -largest and largest, 0 by default. They are in mm or rad, according to
// `quantity`.
Parameter threeNumbers(const char* id, const char* word, std::string meaning, Quantity quantity, double largest);
// Returns the value of a parameter of three numbers.
Vec3 vectorIn(const OperationValues& values, std::string_view id);

}  // namespace handwheel
