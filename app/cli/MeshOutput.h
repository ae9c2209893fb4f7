// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Input.h"
#include "mesh/HalfEdgeMesh.h"

namespace handwheel {

// Writes a mesh that was made from an input: in a mesh format, or as a document of its own numbers, since vertices and
// loops are not those of the input. Errors: those of exportMesh() and saveDocument().
Status writeMesh(const Input& input, const HalfEdgeMesh& mesh, const std::filesystem::path& output,
                 Progress progress = {});

}  // namespace handwheel
