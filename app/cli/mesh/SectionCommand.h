// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Syntax of "handwheel section", which cuts a mesh by a plane and draws the outlines.
CommandSpec sectionSpec();
int runSection(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
