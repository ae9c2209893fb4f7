// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/formats/MeshFormat.h"
#include "mesh/HalfEdgeMesh.h"

#include <filesystem>

namespace handwheel {

struct ExportReport {
  // Vertices moved by the smallest visible amount because in the file they would have welded with another one.
  std::vector<Vertex> parted;
  std::size_t bytes = 0;
};

// Writes the live faces of a mesh: the whole file or nothing (temporary file, fsync, rename). The file is read back,
// welded exactly and compared with the mesh before success is reported.
// Errors: ExtensionUnknown, WriteFailed, CheckFailed, Cancelled.
Result<ExportReport> exportMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                                Progress progress = {});

// Replaces a file's content atomically and durably. Errors: WriteFailed {system's reason}.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace handwheel
