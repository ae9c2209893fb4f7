// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "haptics/recording/Recording.h"

#include <iosfwd>

namespace handwheel {

// Writes a recording as comma-separated values, one line per tick after a header line. Columns: time, tip, proxy and
// force in the scene, contact, computing time; then buttons, the force sent in the frame of the device, the bits of the
// safety chain, the number of the tick, the orientation of the tip as a quaternion, the torques felt and sent, the
// other inputs of a scene's force (velocity of the tip, period, limits of stiffness and damping, whether it begins
// anew, whether there was a scene), events, and the contents of a scene that begins here. mm, N, N·mm, s, us; numbers
// have the shortest form that reads back the same, independent of the locale. Errors: Cancelled, WriteFailed.
Status writeCsv(const Recording& recording, std::ostream& out, Progress progress = {});

// Returns the columns that recordingFromCsv() needs and that the first line of a text does not have, or has twice.
std::vector<std::string_view> missingRecordingColumns(std::string_view text);

// Returns true if a text begins like such a table, with the columns that recordingFromCsv() needs.
bool isRecordingCsv(std::string_view text);

// Reads such a table: the inputs of a scene's force, the force felt, and the events. The forces sent to the device are
// left out. Errors, with the line: HeaderMalformed {what was expected}, NumberMalformed {found}, NumberNotFinite
// {found} (time or position of a tip), DataTruncated {columns, expected, found}, FileTooLarge {ticks}, Cancelled.
Result<Recording> recordingFromCsv(std::string_view text, Progress progress = {});

}  // namespace handwheel
