// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// What the Properties panel does, without a window: "new" makes a document of default size, "set" changes the named
// properties of one; both write the result.
CommandSpec newSpec();
// The kinds of which there are new documents, as lines of the help.
std::string newDetails(const DocumentKinds& kinds);
CommandSpec setSpec();
int runNew(const Arguments& arguments, const DocumentKinds& kinds);
int runSet(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
