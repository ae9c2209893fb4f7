// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Syntax of "handwheel feel", which computes the haptic forces along a path over a mesh.
CommandSpec feelSpec();
int runFeel(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
