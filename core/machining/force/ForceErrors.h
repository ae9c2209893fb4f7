// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

// The error codes of tables and models of cutting forces.
namespace handwheel::ForceErrors {

extern const ErrorDescription ColumnMissing;    // {quantity, its possible names}; a table of cuts has no such column
extern const ErrorDescription ColumnTwice;      // {name}
extern const ErrorDescription DiameterNeeded;   // the table gives r/min, but no cutting speed
extern const ErrorDescription TooFewCuts;       // {found, least}
extern const ErrorDescription MaterialUnknown;  // {id}; there is no such work material

}  // namespace handwheel::ForceErrors
