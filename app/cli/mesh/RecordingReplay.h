// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

#include <string_view>

namespace handwheel {

// Runs 'handwheel feel MESH --path RECORDING.csv': replays a haptic recording on a mesh. Each scene of the recording is
// simulated again and compared with the recorded forces. text: the contents of the recording's table. Returns the exit
// code.
int replayRecording(const Arguments& arguments, std::string_view text, const DocumentKinds& kinds);

}  // namespace handwheel
