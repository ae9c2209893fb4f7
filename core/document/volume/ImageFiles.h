// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/Note.h"
#include "volume/image/ImageFile.h"

#include <filesystem>
#include <span>

namespace handwheel {

// Reads a three-dimensional image from a file or a DICOM series. A file is in NRRD, MetaImage or NIfTI, or describes
// plain samples. DICOM: the largest series of a folder, or the series of a file, with the other files of it in the same
// folder. Data in separate files are read only from the folder of the header and its subfolders. Errors: FileMissing,
// FileUnreadable, FileTooLarge, DocumentError::FormatUnknown, VolumeErrors::FolderWithoutSeries; those of the readers;
// OutOfMemory, Cancelled.
Result<ImageFile> readImageFile(const std::filesystem::path& path, Progress progress);

// Returns true if the first bytes are those of an image.
bool looksLikeImage(std::string_view head);

// Returns the remarks as notes.
std::vector<Note> notesOn(std::span<const ImageRemark> remarks);

// Returns the name of an image for storage and display: that of the file, except for DICOM, whose names often contain
// the patient's.
std::string sourceName(const std::filesystem::path& path);

// Returns the title of a document made from a DICOM series: the name of its folder. Empty for a single file.
std::string seriesTitle(const std::filesystem::path& path);

}  // namespace handwheel
