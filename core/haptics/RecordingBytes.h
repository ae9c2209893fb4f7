// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "haptics/Recording.h"

#include <string>
#include <string_view>

namespace handwheel {

// A recording as bytes, to be saved with a document: little-endian, every number with all its bits. "HWFR", version 1
// and the number of events (each u32), the number of ticks (u64); the events: tick (u64), length (u32), text; the ticks
// one after another in 312 bytes: 37 doubles, then tick number (u64), buttons and flags (u32 each).
std::string recordingBytes(const Recording& recording);
// The same of the ticks from `first` to before `last` alone, with the events that belong to them: those after the tick
// before; behind the last tick of all also what is left.
std::string recordingBytes(const Recording& recording, std::size_t first, std::size_t last);

// And back. Errors: HeaderMalformed, VersionNewer, DataTruncated, CountMismatch (more than announced), NumberNotFinite
// (a tip that is nowhere, or at no time). Memory in proportion to the bytes given, whatever they announce.
Result<Recording> recordingFromBytes(std::string_view bytes);

}  // namespace handwheel
