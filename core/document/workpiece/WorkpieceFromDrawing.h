// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

namespace handwheel {

// Returns true if a file is a drawing according to its first bytes. A drawing opens as a bar with a target.
bool looksLikeDrawing(std::string_view head);

// Reads a drawing as a new bar with the drawn shape as its target. The bar is thicker than the part by 2 mm or a little
// more, and longer by 1 mm for facing and 30 mm for the chuck and parting. The document does not count as saved, so
// saving the bar never replaces the drawing. Blocks the calling thread. Errors: the errors of importTarget() and
// checkValue().
Result<OpenedFile> openDrawing(const DocumentKind& kind, const std::filesystem::path& path, Progress progress);

}  // namespace handwheel
