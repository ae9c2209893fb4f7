// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/RecordingExport.h"

#include "document/AtomicFile.h"
#include "haptics/recording/RecordingCsv.h"

#include <new>
#include <sstream>

namespace handwheel {

Status exportRecording(const Recording& recording, const std::filesystem::path& path, Progress progress) {
  try {
    std::ostringstream table;
    if (const Status done = writeCsv(recording, table, progress.part(0.0, 0.8)); !done) return done.error();
    return writeFileAtomically(path, table.view(), progress.part(0.8, 1.0));
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::OutOfMemory, {}, {}, path.string()};
  }
}

}  // namespace handwheel
