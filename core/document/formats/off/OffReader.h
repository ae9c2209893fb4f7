// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads an OFF file in text or binary ("OFF BINARY"). The keyword may be missing. Faces of one or two corners are
// points and lines, which are listed as lost.
Result<MeshFile> readOff(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
