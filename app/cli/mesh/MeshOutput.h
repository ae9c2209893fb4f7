// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "cli/Input.h"
#include "mesh/structure/HalfEdgeMesh.h"

namespace handwheel {

// Returns the option -o of commands that write a mesh.
OptionSpec meshOutputOption();
// Returns the words of the formats of meshes, as --format takes them: "stl, ply, obj, off or 3mf".
std::string meshFormatWords(bool withContainer);
// Returns the names of the mesh formats: "STL, PLY, OBJ, OFF or 3MF".
std::string meshFormatNames();

// Writes a mesh that was computed from an input file. The format is a mesh format, or a container with its own
// numbering, since vertices and loops differ from those of the input. Errors: the errors of exportMesh() and
// saveDocument().
Status writeMesh(const Input& input, const HalfEdgeMesh& mesh, const std::filesystem::path& output,
                 Progress progress = {});

}  // namespace handwheel
