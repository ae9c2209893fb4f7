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

// Links of bodies to the files that their shapes were read from. folder: the folder of the document that contains the
// body; empty for a document that was never saved.

// The largest size of a file that a body can be linked to, bytes.
inline constexpr std::uintmax_t kLargestLinkedFile = std::uintmax_t{1} << 30;

// Returns a link to a file in its present state. Errors: FileMissing, FileUnreadable, FileTooLarge; Unsupported for a
// path that is not UTF-8, as a manifest cannot contain it; Cancelled.
Result<BodyLink> linkTo(const std::filesystem::path& path, Progress progress = {});

// Returns the path of the linked file relative to the folder in which the document is saved. The relative path of the
// link does not change if the file is missing, so that it is found when it comes back.
std::string relativePathOf(const BodyLink& link, const std::filesystem::path& folder);

// Returns the present path of the linked file. It is looked for at the same path relative to the document, at its last
// path, and in the folder of the document. The result is empty if it is not found.
std::filesystem::path locateLink(const BodyLink& link, const std::filesystem::path& folder);

// Returns the bodies with the states of their links, and the present paths of the unchanged files. The notes receive
// missing and changed files, and shapes of unknown kinds. Each linked file is read once. After a cancellation the
// remaining links stay unchecked.
BodySet withCheckedBodyLinks(const BodySet& bodies, const std::filesystem::path& folder, std::vector<Note>& notes,
                             Progress progress = {});

}  // namespace handwheel
