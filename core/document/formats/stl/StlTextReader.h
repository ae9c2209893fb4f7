// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Reads a text STL file. There may be any number of solids; keywords may be in upper or lower case. The text after
// "solid" is a name.
Result<MeshFile> readTextStl(std::string_view bytes, const ReadOptions& options, Progress progress);

}  // namespace handwheel
