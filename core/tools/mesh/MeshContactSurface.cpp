// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshContactSurface.h"

#include "haptics/contact/TouchableSurface.h"

namespace handwheel {

ContactSurface contactSurfaceOf(const HalfEdgeMesh& mesh, Progress progress) {
  HalfEdgeMesh::Compact all = mesh.compact();
  return touchableSurface(std::move(all.soup.points), std::move(all.soup.triangles), all.faceOf, progress);
}

void updateSurface(ContactSurface& surface, const HalfEdgeMesh& mesh, const std::vector<Face>& touched) {
  std::vector<std::uint32_t> removed;
  std::vector<ContactTriangle> added;
  for (const Face f : touched) {
    removed.push_back(touchableNumber(f));
    if (f < mesh.faceSlots() && mesh.isLive(f)) added.push_back({mesh.points(f), touchableNumber(f)});
  }
  surface.update(removed, added);
}

}  // namespace handwheel
