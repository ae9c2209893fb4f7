// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "document/StoredRecording.h"

#include <vector>

namespace handwheel {

// Storage of recordings in a container. Their metadata is in the manifest's object "recordings", by key. Their ticks
// are in the blobs "recordings/KEY/0000", …. Each blob is a recording of its own (haptics/recording/RecordingBytes.h),
// so a damaged byte destroys at most one blob.
inline constexpr const char* kRecordingFolder = "recordings/";

// Writes the metadata of recordings to the manifest.
void listRecordings(const std::vector<StoredRecording>& recordings, nlohmann::json& manifest);
// Writes the ticks of recordings to blobs.
void writeRecordings(const std::vector<StoredRecording>& recordings, Container& container);

// Reads the recordings of a container. Accepts any input, and returns everything that can be recovered. For each
// recording with missing ticks, a DataTruncated error with their number is added to `damage`.
std::vector<StoredRecording> readRecordings(const Container& container, std::vector<Error>& damage);

}  // namespace handwheel
