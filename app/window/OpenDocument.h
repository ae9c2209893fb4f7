// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/MeshDocument.h"
#include "mesh/Repair.h"
#include "panels/Inspection.h"
#include "viewport/CameraState.h"

#include <optional>

namespace handwheel {

// A document with what the window remembers about it while it is open.
struct OpenDocument {
  OpenDocument(const QString& path, MeshFile file, InspectedMesh mesh, BuildReport build)
      : document(path, std::move(file), std::move(mesh), std::move(build)), inspection(document) {}

  MeshDocument document;
  Inspection inspection;
  std::optional<CameraState> camera;  // absent until it was shown
  Vertex selected = kNone;            // Inspection::keyOf the selected loop
  bool visible = true;
  bool written = false;  // its file was written by us, so it holds nothing that the document does not
  bool cardDismissed = false;
  bool repaired = false;  // "Repair all" ran at least once
};

}  // namespace handwheel
