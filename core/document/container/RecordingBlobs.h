// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/KeptRecording.h"

#include <vector>

namespace handwheel {

// Recordings in a container: what is said of them in the manifest's object "recordings", by key, and their ticks in the
// blobs "recordings/KEY/0000", …, each a recording of its own (haptics/RecordingBytes.h): a damaged byte costs one.
inline constexpr const char* kRecordingFolder = "recordings/";

void listRecordings(const std::vector<KeptRecording>& recordings, nlohmann::json& manifest);
void writeRecordings(const std::vector<KeptRecording>& recordings, Container& container);

// Expects anything, and gives what can be had. Of each that lacks ticks it is said how many: DataTruncated.
std::vector<KeptRecording> readRecordings(const Container& container, std::vector<Error>& damage);

}  // namespace handwheel
