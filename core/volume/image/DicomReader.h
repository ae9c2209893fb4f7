// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/image/ImageFile.h"

#include <span>

namespace handwheel {

inline constexpr const char* kDicomLibrary = "GDCM";

// The series that is read if the files contain several.
enum class DicomChoice { OfFirst, Largest };

// Appends a file to the input of readDicom().
void appendDicomFile(std::string_view file, std::string& files);

// Reads the image of a series of DICOM from its files in any order, in a process of its own (IsolatedReader.h): its
// slices in the order of their positions, rescaled. Tilted slices stay as they are (ImageGrid); for uneven and missing
// slices there is a remark, and values between them are interpolated linearly. No data about the patient is returned.
// Errors: LibraryFailed with the reason, OutOfMemory, Cancelled.
Result<ImageFile> readDicom(std::string_view files, DicomChoice choice, Progress progress);

// Reads the image in the answer of plugins/formats/dicom, which is not trusted. Errors: LibraryFailed if it is
// malformed.
Result<ImageFile> imageInAnswer(std::string_view answer);

// Returns true if the first bytes are those of a DICOM file.
bool looksLikeDicom(std::string_view bytes);

}  // namespace handwheel
