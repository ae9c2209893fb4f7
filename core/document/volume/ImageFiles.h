// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/Note.h"
#include "volume/image/ImageFile.h"

#include <filesystem>
#include <span>

namespace handwheel {

// Reads a three-dimensional image from a file or a DICOM series. A file is in NRRD, MetaImage, NIfTI or has a
// description of plain samples. DICOM: the largest series of a folder, or the one that a file is of, with the others of
// it in its folder. Data in a file of their own are read from the folder of the header and those below it, and from
// nowhere else. Errors: FileMissing, FileUnreadable, FileTooLarge, DocumentError::FormatUnknown,
// VolumeErrors::FolderWithoutSeries; those of the readers; OutOfMemory, Cancelled.
Result<ImageFile> readImageFile(const std::filesystem::path& path, Progress progress);

// Whether the first bytes are those of an image.
bool looksLikeImage(std::string_view head);

// The remarks in words.
std::vector<Note> notesOn(std::span<const ImageRemark> remarks);

// The name of an image where it is kept or shown: that of the file, but for DICOM, whose names are often the patient's.
std::string sourceName(const std::filesystem::path& path);

// What a document of a series of DICOM is called: as the folder of its files. Empty: it is a file by itself.
std::string seriesTitle(const std::filesystem::path& path);

}  // namespace handwheel
