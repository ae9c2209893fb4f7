// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "haptics/recording/Recording.h"

#include <filesystem>

namespace handwheel {

// Writes a recording to a CSV file (haptics/RecordingCsv.h). Writes the whole file or nothing. Errors: WriteFailed,
// OutOfMemory, Cancelled.
Status exportRecording(const Recording& recording, const std::filesystem::path& path, Progress progress = {});

}  // namespace handwheel
