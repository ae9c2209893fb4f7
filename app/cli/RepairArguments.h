// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "cli/RepairJob.h"

namespace handwheel {

// What the options say about the repair itself, and how a file is read. Returns what is wrong with them, or nothing.
std::string readRepairOptions(const Arguments& arguments, RepairRequest& request);

// The words for a single file, IN and OUT among them. Returns what is wrong with them, or nothing.
std::string readRequest(const Arguments& arguments, const DocumentKinds& kinds, RepairRequest& request);

// The user's word for the lengths of the files, by which nothing is scaled.
std::string unitOf(const Arguments& arguments);

}  // namespace handwheel
