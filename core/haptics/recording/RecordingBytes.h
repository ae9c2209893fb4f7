// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "haptics/recording/Recording.h"

#include <string>
#include <string_view>

namespace handwheel {

// Serialises a recording to bytes, to be saved with a document. Numbers are little-endian and keep all their bits. The
// bytes begin with "HWFR", the version 1 and the number of events (u32 each), and the number of ticks (u64). The events
// follow: tick (u64), length (u32) and text. The ticks come last, with 312 bytes each: 37 doubles, the tick number
// (u64), buttons and flags (u32 each).
std::string recordingBytes(const Recording& recording);
// Serialises the ticks from `first` up to but excluding `last`, with their events. These are the events after the
// previous tick. If the last tick of the recording is included, all remaining events are, too.
std::string recordingBytes(const Recording& recording, std::size_t first, std::size_t last);

// Deserialises a recording. Errors: HeaderMalformed, VersionNewer, DataTruncated, CountMismatch (more bytes than
// declared), NumberNotFinite (position or time of a tip). The memory is proportional to the number of bytes, regardless
// of the numbers that they declare.
Result<Recording> recordingFromBytes(std::string_view bytes);

}  // namespace handwheel
