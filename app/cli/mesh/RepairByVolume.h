// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// The options of 'repair' by volume.
std::vector<OptionSpec> volumeRepairOptions();
// Whether the arguments ask for it.
bool isByVolume(const Arguments& arguments);

// Repairs one file by the volume that it encloses. Returns the exit code.
int runRepairByVolume(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
