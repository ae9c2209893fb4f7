// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Note.h"
#include "scene/BodySet.h"

#include <filesystem>
#include <vector>

namespace handwheel {

// Links of bodies to the files that their shapes were read from. folder: of the document that holds the body; empty for
// one that was never saved.

// The largest file that a body can be linked to, bytes.
inline constexpr std::uintmax_t kLargestLinkedFile = std::uintmax_t{1} << 30;

// A link to a file as it is now. Errors: FileMissing, FileUnreadable, FileTooLarge; Unsupported for a path that is not
// UTF-8, which a manifest cannot hold; Cancelled.
Result<BodyLink> linkTo(const std::filesystem::path& path, Progress progress = {});

// The way to the linked file from this folder, in which a document with the link is saved. As it was where the file is
// missing, so that it is found when it comes back.
std::string relativePathOf(const BodyLink& link, const std::filesystem::path& folder);

// Where the file of a link is now: at the same place beside the document, where it was, or in the folder of the
// document. Empty when it is at none of these.
std::filesystem::path locateLink(const BodyLink& link, const std::filesystem::path& folder);

// The bodies with the states of their links, and where the unchanged files are now. Those that are missing or changed
// are added to the notes, as are shapes of unknown kinds. Reads each linked file once. Cancelled: the rest stays
// unchecked.
BodySet withCheckedBodyLinks(const BodySet& bodies, const std::filesystem::path& folder, std::vector<Note>& notes,
                             Progress progress = {});

}  // namespace handwheel
