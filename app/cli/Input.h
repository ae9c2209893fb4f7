// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"

#include <optional>

namespace handwheel {

// What a file named on the command line is: a mesh as the file holds it, or a document of another kind.
struct Input {
  std::optional<MeshFile> mesh;
  OpenedFile document;  // when it is no mesh, or comes from a container
};

// Reads a mesh file as it stands there, unwelded, or the mesh in a container, or any other document. Errors: those of
// the readers.
Result<Input> readInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                        Progress progress);

// The same for commands that work on meshes only: others are Unsupported.
Result<MeshFile> readMeshInput(const std::filesystem::path& path, const ReadOptions& options,
                               const DocumentKinds& kinds, Progress progress);

// What is to be said about a file that could not be read whole, or holds more than is kept.
void tellLosses(const std::vector<Error>& damage, std::size_t unlistedDamage, const std::vector<LostAttribute>& lost);

}  // namespace handwheel
