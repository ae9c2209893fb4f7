// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

namespace handwheel {

// Returns true if a file is a drawing, by its first bytes. It opens as a bar with a target.
bool looksLikeDrawing(std::string_view head);

// Reads a drawing as a new bar with the drawn shape as its target. The bar is 2 mm or a little more thicker than the
// part, and longer by 1 mm to be faced and 30 mm for chuck and parting. The document does not count as saved, so saving
// the bar never replaces the drawing. Blocks. Errors: those of importTarget() and checkValue().
Result<OpenedFile> openDrawing(const DocumentKind& kind, const std::filesystem::path& path, Progress progress);

}  // namespace handwheel
