// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/DocumentKind.h"
#include "machining/drawing/PartDrawing.h"

#include <filesystem>

namespace handwheel {

// Returns the file formats of drawings. DXF and SVG contain the exact half section, and PDF contains a drawing with
// dimensions.
std::vector<FileFormat> drawingFormats();
// Returns true if a path has the extension of one of these formats.
bool isDrawingName(const std::filesystem::path& path);

// Writes a section in the format that the extension of the path names. Either the whole file is written or nothing. DXF
// and SVG are read back and compared within 1e-6 mm. PDF needs fonts and therefore a QGuiApplication. Errors:
// CheckFailed, LibraryFailed, and the errors of writeFileAtomically().
Result<WrittenFile> exportDrawing(const TargetProfile& section, const DrawingTitle& title,
                                  const std::filesystem::path& path, Progress progress);

}  // namespace handwheel
