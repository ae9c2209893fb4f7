// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "volume/image/ImageFile.h"

#include <span>

namespace handwheel {

inline constexpr const char* kDicomLibrary = "GDCM";

// Which series of several files is read.
enum class DicomChoice { OfFirst, Largest };

// Appends a file to those that readDicom() reads.
void appendDicomFile(std::string_view file, std::string& files);

// Reads the image of a series of DICOM from its files in any order, in a process of its own (IsolatedReader.h): its
// slices in the order of their places, rescaled. Tilted slices stay as they are (ImageGrid); of uneven and missing ones
// there is a remark, and values between them are linear. Nothing of the patient comes back.
// Errors: LibraryFailed with the reason, OutOfMemory, Cancelled.
Result<ImageFile> readDicom(std::string_view files, DicomChoice choice, Progress progress);

// Reads the image in the answer of plugins/formats/dicom, which is as little trusted as any file. Errors: LibraryFailed
// where it makes no sense.
Result<ImageFile> imageInAnswer(std::string_view answer);

// Whether the first bytes are those of a file of DICOM.
bool looksLikeDicom(std::string_view bytes);

}  // namespace handwheel
