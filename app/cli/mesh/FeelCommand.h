// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Returns the syntax of "handwheel feel", which computes haptic forces along a path.
CommandSpec feelSpec();
int runFeel(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
