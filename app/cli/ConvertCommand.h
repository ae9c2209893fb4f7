// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

CommandSpec convertSpec();
// What can be written of each kind, as lines of the help.
std::string convertDetails(const DocumentKinds& kinds);
int runConvert(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
