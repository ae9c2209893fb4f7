// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace handwheel {

// Replaces a file's content atomically and durably. Writes a temporary file in the same folder (unnamed if the system
// supports that), flushes it, renames it and flushes the folder. A symbolic link stays and its target is replaced;
// permissions stay. Checks the cancel flag between blocks of 1 MiB. A cancelled or failed write removes its temporary
// file; that of a killed program is removed by the next write (AtomicSaveFile.h). A character device (/dev/null, a
// terminal) is written to directly. Errors: WriteFailed {system's reason}, Cancelled.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, Progress progress = {});

// A path and the content to write to it.
struct FileContent {
  std::filesystem::path path;
  std::string_view bytes;
};

// Replaces the content of several files atomically, one after the other. All contents are on the disk before the first
// file is replaced. After an error the last file has its old content, unless only its folder could not be flushed. The
// paths must be different. Errors: the errors of writeFileAtomically().
Status writeFilesAtomically(std::span<const FileContent> files, Progress progress = {});

// Flushes the entries of a folder to disk, so that creations, renamings and removals of files survive a power failure.
// Returns false on failure; errno then has the reason.
bool syncFolder(const std::filesystem::path& folder);

// Returns true while a file is being written, when the end of the program would leave a temporary file. No write begins
// after its progress was cancelled. May be called on any thread.
bool isWritingFile();

}  // namespace handwheel
