// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace handwheel {

// Replaces a file's content atomically and durably. Uses a temporary file in its folder, unnamed if the system supports
// that, fsync, rename, and fsync of the folder. A symbolic link stays and its target is replaced; permissions stay.
// Checks the cancel flag between blocks of 1 MiB; a cancelled or failed write leaves nothing behind, and the leftovers
// of a killed one are removed by the next one (AtomicSaveFile.h). A character device (/dev/null, a terminal) is written
// to directly. Errors: WriteFailed {system's reason}, Cancelled.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, Progress progress = {});

// A path and the content to write to it.
struct FileContent {
  std::filesystem::path path;
  std::string_view bytes;
};

// Replaces the content of several files atomically, one after the other. All of them are on the disk before the first
// is replaced, and the last one decides: after an error it is the old one, unless only its folder could not be
// synchronised. No two may be the same. Errors: those of writeFileAtomically().
Status writeFilesAtomically(std::span<const FileContent> files, Progress progress = {});

// Flushes the entries of a folder to disk. Files created, renamed or removed in it then survive a power failure.
// Returns false on failure; errno is the reason.
bool syncFolder(const std::filesystem::path& folder);

// Returns true if a file is being written now. If the program ended now, a temporary file would be left. No write
// begins after its progress was cancelled. Any thread.
bool isWritingFile();

}  // namespace handwheel
