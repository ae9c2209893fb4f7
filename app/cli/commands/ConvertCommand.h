// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Syntax of "handwheel convert", which writes a document in another format.
CommandSpec convertSpec();
// Returns the formats in which each kind of document can be written, as lines of the help page.
std::string convertDetails(const DocumentKinds& kinds);
int runConvert(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
