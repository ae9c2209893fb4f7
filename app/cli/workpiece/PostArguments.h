// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "machining/program/ProgramSetup.h"

#include <string>

namespace handwheel {

// Changes a tool post as --post and --insert say. If only --post is given, the inserts face the side that cuts with M3.
// Returns a sentence about a problem, or an empty string.
std::string readPost(const Arguments& arguments, ProgramPost& post);

// Returns the specifications of both options.
std::vector<OptionSpec> postOptions();

}  // namespace handwheel
