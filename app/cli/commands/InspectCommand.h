// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Command.h"

namespace handwheel {

// Syntax of "handwheel inspect", which reports the contents and the defects of a file.
CommandSpec inspectSpec();
int runInspect(const Arguments& arguments, const Registered& registered);

}  // namespace handwheel
