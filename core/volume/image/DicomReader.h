// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/image/ImageFile.h"

#include <span>

namespace handwheel {

inline constexpr const char* kDicomLibrary = "GDCM";

// The choice of a series if the files contain several. OfFirst: the series of the first file.
enum class DicomChoice { OfFirst, Largest };

// Appends a file to the input of readDicom().
void appendDicomFile(std::string_view file, std::string& files);

// Reads the image of a DICOM series from its files in any order, in a separate process (IsolatedReader.h). The slices
// are sorted by their positions and rescaled. Tilted slices stay tilted (ImageGrid). Uneven and missing slices cause a
// remark, and values between slices are interpolated linearly. No data about the patient are returned. Errors:
// LibraryFailed with the reason, OutOfMemory, Cancelled.
Result<ImageFile> readDicom(std::string_view files, DicomChoice choice, Progress progress);

// Reads the image in the answer of plugins/formats/dicom, which is not trusted. Error: LibraryFailed if the answer is
// malformed.
Result<ImageFile> imageInAnswer(std::string_view answer);

// Number of bytes at the beginning of a file that suffice for looksLikeDicom().
inline constexpr std::size_t kDicomHead = 16 << 10;
// Returns true if a file that begins with these bytes is in DICOM, with a preamble or without.
bool looksLikeDicom(std::string_view bytes);

}  // namespace handwheel
