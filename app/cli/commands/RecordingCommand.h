// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Syntax of "handwheel recording", which writes a recording of a haptic device as CSV.
CommandSpec recordingSpec();
int runRecording(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
