// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/Note.h"
#include "volume/image/ImageFile.h"

#include <filesystem>
#include <span>

namespace handwheel {

// Reads a three-dimensional image from a file or a DICOM series. A file is in NRRD, MetaImage or NIfTI, or is a
// description of plain samples. For DICOM, reads the largest series of a folder and the folders in it, or the series of
// a file including its other files in the same folder. Data in separate files are read only from the folder of the
// header and its subfolders. An image whose values are labels becomes a label map (ImageLabels.h): if its file or its
// name says so, or if looksLikeLabels(). Errors: FileMissing, FileUnreadable, FileTooLarge,
// DocumentError::FormatUnknown, VolumeErrors::FolderWithoutSeries; the errors of the readers; OutOfMemory, Cancelled.
Result<ImageFile> readImageFile(const std::filesystem::path& path, Progress progress);

// Returns true if a file that begins with these bytes is an image.
bool looksLikeImage(std::string_view head);

// Converts the remarks of an image to notes for the user.
std::vector<Note> notesOn(std::span<const ImageRemark> remarks);

// Returns true for an image and for a folder of images: their names are often those of patients. Such a name must not
// be written into a file that may leave the machine.
bool isPrivateName(const std::filesystem::path& path);
// Returns the name of the source of a document, as it is stored. It is the name of the file, or that of its format if
// isPrivateName().
std::string sourceName(const std::filesystem::path& path);

// Returns the title of a document made from a DICOM series: the name of its folder. The title of a single file is
// empty.
std::string seriesTitle(const std::filesystem::path& path);

}  // namespace handwheel
