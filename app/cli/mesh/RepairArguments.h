// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "cli/mesh/RepairJob.h"

namespace handwheel {

// Parses the options for reading a file and for repairing it. Returns the error as a sentence, or an empty string.
std::string readRepairOptions(const Arguments& arguments, RepairRequest& request);

// Parses the arguments for a single file, including IN and OUT. Returns the error as a sentence, or an empty string.
std::string readRequest(const Arguments& arguments, const DocumentKinds& kinds, RepairRequest& request);

// Returns the unit that the user gave for the coordinates in the files, "mm" by default. It only labels them: nothing
// is scaled.
std::string unitOf(const Arguments& arguments);

}  // namespace handwheel
