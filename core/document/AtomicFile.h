// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"

#include <filesystem>
#include <span>
#include <string_view>

namespace handwheel {

// Replaces a file's content atomically and durably: a temporary file in its folder, without a name where the system
// knows such files, fsync, rename, fsync of the folder. A symbolic link stays and its target is replaced; permissions
// stay. Looks at the cancel flag between blocks of 1 MiB; a cancelled or failed write leaves nothing behind, and what a
// killed one may leave the next one removes (DraftFile.h). A character device (/dev/null, a terminal) is written to as
// it stands. Errors: WriteFailed {system's reason}, Cancelled.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes, Progress progress = {});

struct FileContent {
  std::filesystem::path path;
  std::string_view bytes;
};

// Replaces several files. All of them are on the disk before the first takes its place, and the last is the one that
// counts: with an error it is the old one, unless only its folder could not be synchronised. No two may be the same.
// Errors: as above.
Status writeFilesAtomically(std::span<const FileContent> files, Progress progress = {});

// Makes what was created, renamed or removed in a folder last through a power cut. False: errno says why it may not.
bool syncFolder(const std::filesystem::path& folder);

// Whether one is being written now: a program that ended itself here would leave a temporary file. Once its progress is
// cancelled none begins. Any thread.
bool isWritingFile();

}  // namespace handwheel
