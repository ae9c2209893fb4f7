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

// Links of bodies to the files that their shapes were read from. folder: the folder of the document with the body;
// empty for a document that was never saved.

// The largest file that a body can be linked to, bytes.
inline constexpr std::uintmax_t kLargestLinkedFile = std::uintmax_t{1} << 30;

// Returns a link to a file in its present state. Errors: FileMissing, FileUnreadable, FileTooLarge; Unsupported for a
// path that is not UTF-8, which a manifest cannot hold; Cancelled.
Result<BodyLink> linkTo(const std::filesystem::path& path, Progress progress = {});

// Returns the path of the linked file relative to this folder, in which the document is saved. Unchanged if the file is
// missing, so that it is found when it comes back.
std::string relativePathOf(const BodyLink& link, const std::filesystem::path& folder);

// Returns the present path of the linked file: at the same path relative to the document, at its last path, or in the
// folder of the document. Empty if it is at none of these.
std::filesystem::path locateLink(const BodyLink& link, const std::filesystem::path& folder);

// Returns the bodies with the states of their links, and the present paths of the unchanged files. Missing and changed
// files are added to the notes, as are shapes of unknown kinds. Reads each linked file once. Cancelled: the rest stays
// unchecked.
BodySet withCheckedBodyLinks(const BodySet& bodies, const std::filesystem::path& folder, std::vector<Note>& notes,
                             Progress progress = {});

}  // namespace handwheel
