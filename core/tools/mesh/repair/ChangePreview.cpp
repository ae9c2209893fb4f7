// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/ChangePreview.h"

#include "mesh/structure/MeshDelta.h"

namespace handwheel {

ChangePreview previewOf(const MeshChange& change, const HalfEdgeMesh& mesh, Progress progress) {
  HalfEdgeMesh after = mesh;
  change.apply(after, progress);
  if (progress.cancelled()) return {};
  ChangePreview preview;
  // Some of them differ in their neighbours only, which nobody sees.
  const std::vector<Face> touched = MeshDelta::between(mesh, after).touchedFaces(mesh);
  for (const Face f : FaceSelection(touched).faces()) {
    const bool was = f < mesh.faceSlots() && mesh.isLive(f);
    const bool is = f < after.faceSlots() && after.isLive(f);
    if (was && is && mesh.points(f) == after.points(f)) continue;
    if (was) preview.removed.add(f);
    if (!is) continue;
    const auto first = static_cast<std::uint32_t>(preview.added.points.size());
    for (const Vec3& p : after.points(f)) preview.added.points.push_back(p);
    preview.added.triangles.push_back({first, first + 1, first + 2});
  }
  if (preview.isEmpty()) preview.reason = reasonOf(change);
  return preview;
}

}  // namespace handwheel
