// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "haptics/recording/Recording.h"

#include <string>
#include <string_view>

namespace handwheel {

// Serialises a recording to bytes, to be saved with a document. Little-endian, every number with all its bits. "HWFR",
// version 1 and the number of events (each u32), the number of ticks (u64); the events: tick (u64), length (u32), text;
// the ticks one after another in 312 bytes: 37 doubles, then tick number (u64), buttons and flags (u32 each).
std::string recordingBytes(const Recording& recording);
// Serialises only the ticks from `first` to before `last`, with their events. These are the events after the previous
// tick, and with the last tick of all also the remaining ones.
std::string recordingBytes(const Recording& recording, std::size_t first, std::size_t last);

// Deserialises a recording. Errors: HeaderMalformed, VersionNewer, DataTruncated, CountMismatch (more than declared),
// NumberNotFinite (position or time of a tip). Memory is proportional to the bytes given, whatever they declare.
Result<Recording> recordingFromBytes(std::string_view bytes);

}  // namespace handwheel
