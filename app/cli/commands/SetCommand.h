// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Syntax of "handwheel new", which writes a document of default size. The commands "new" and "set" provide the
// functions of the Properties panel without a window.
CommandSpec newSpec();
// Returns the kinds that "new" can create, as lines of the help page.
std::string newDetails(const DocumentKinds& kinds);
// Syntax of "handwheel set", which changes named properties of a document and writes the result.
CommandSpec setSpec();
int runNew(const Arguments& arguments, const DocumentKinds& kinds);
int runSet(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
