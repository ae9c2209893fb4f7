// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/selection/PreviewMesh.h"
#include "tools/Tool.h"

namespace handwheel {

struct ClayState;

// The preview of a tool on the mesh of a document.
struct MeshPreview : KindPreview {
  FaceSelection highlighted;                       // faces under the pointer or about to be selected
  FaceSelection selected;                          // faces that are selected now
  std::shared_ptr<const PreviewMesh> previewMesh;  // null: the document's mesh
  std::shared_ptr<const ClayState> voxels;         // voxels whose surface is shown beside the mesh; null: none
};

// Returns the part of a preview that is on the mesh. The result is empty if there is none.
inline MeshPreview meshPreviewOf(const ToolPreview& preview) {
  const auto* own = dynamic_cast<const MeshPreview*>(preview.ofKind.get());
  return own ? *own : MeshPreview();
}

}  // namespace handwheel
