// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Returns the syntax of "handwheel section", which draws a plane section of a mesh.
CommandSpec sectionSpec();
int runSection(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
