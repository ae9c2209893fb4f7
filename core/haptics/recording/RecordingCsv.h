// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "haptics/recording/Recording.h"

#include <iosfwd>

namespace handwheel {

// Writes a recording as comma-separated values, with a header line and one line per tick. The first columns are time,
// tip, proxy and force in the scene, contact, and computing time. The other columns are the buttons, the force sent in
// the frame of the device, the bits of the safety chain, the number of the tick, the orientation of the tip as a
// quaternion, the torques felt and sent, the other inputs of a scene's force (velocity of the tip, period, limits of
// stiffness and damping, flags for a restart and for the presence of a scene), events, and the contents of a scene that
// begins at the tick. Units are mm, N, N·mm, s and us. Numbers have the shortest form from which they can be restored,
// independent of the locale. Errors: Cancelled, WriteFailed.
Status writeCsv(const Recording& recording, std::ostream& out, Progress progress = {});

// Returns the columns required by recordingFromCsv() that the first line of a text contains not at all or twice.
std::vector<std::string_view> missingRecordingColumns(std::string_view text);

// Returns true if the first line of a text contains the columns required by recordingFromCsv().
bool isRecordingCsv(std::string_view text);

// Reads a table that writeCsv() has written: the inputs of a scene's force, the force felt, and the events. The forces
// sent to the device are omitted. Errors, with the line: HeaderMalformed {what was expected}, NumberMalformed {found},
// NumberNotFinite {found} (time or position of a tip), DataTruncated {columns, expected, found}, FileTooLarge {ticks},
// Cancelled.
Result<Recording> recordingFromCsv(std::string_view text, Progress progress = {});

}  // namespace handwheel
