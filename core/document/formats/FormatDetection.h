// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"

namespace handwheel {

// Detects the format of a mesh file by its content. By its name where the content is ambiguous. Errors: FileEmpty,
// TextEncoding, FormatUnknown.
Result<MeshFormat> detectFormat(std::string_view bytes, std::string_view name);

}  // namespace handwheel
