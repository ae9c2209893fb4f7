// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/MeshOutput.h"

#include "document/formats/MeshExport.h"
#include "document/mesh/MeshKind.h"

namespace handwheel {

Status writeMesh(const Input& input, const HalfEdgeMesh& mesh, const std::filesystem::path& output, Progress progress) {
  if (!isContainerName(output)) {
    const auto exported = exportMesh(mesh, input.mesh->numbers, output, progress);
    return exported ? Status(Done{}) : Status(exported.error());
  }
  MeshFile file;
  file.soup = mesh.compact().soup;
  file.numbers = input.mesh->numbers;
  const auto content = meshSnapshotOf(file, tolerance::kNearWeld, progress.part(0.0, 0.5));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const auto saved = saveDocument(*input.opened.kind, input.opened.file, *content, output, progress.part(0.5, 1.0));
  return saved ? Status(Done{}) : Status(saved.error());
}

}  // namespace handwheel
