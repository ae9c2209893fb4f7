// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "document/DocumentKind.h"
#include "machining/drawing/PartDrawing.h"

#include <filesystem>

namespace handwheel {

// Returns the file formats of drawings. DXF and SVG hold the exact half section, PDF a drawing with dimensions.
std::vector<FileFormat> drawingFormats();
bool isDrawingName(const std::filesystem::path& path);

// Writes a section in the format that the extension of the path names: the whole file or nothing. DXF and SVG are read
// back and compared within 1e-6 mm. PDF needs fonts, so a QGuiApplication. Errors: CheckFailed, LibraryFailed, those of
// writeFileAtomically().
Result<WrittenFile> exportDrawing(const TargetProfile& section, const DrawingTitle& title,
                                  const std::filesystem::path& path, Progress progress);

}  // namespace handwheel
