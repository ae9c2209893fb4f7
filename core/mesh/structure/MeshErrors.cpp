// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/MeshErrors.h"

namespace handwheel {

const ErrorDescription MeshError::NoTriangles{
    .id = "NoTriangles",
    .sentences = {translatable("ErrorText", "the file contains no triangles")},
    .advice = {translatable(
        "ErrorText", "Export the model as a surface of triangles; points and curves alone cannot be repaired.")}};

}  // namespace handwheel
