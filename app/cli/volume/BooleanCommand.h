// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Returns the command "handwheel boolean", which unites, subtracts or intersects the material of two documents.
Command booleanCommand();

}  // namespace handwheel
