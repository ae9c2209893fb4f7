// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/mesh/MeshDocument.h"
#include "mesh/Repair.h"
#include "panels/Inspection.h"
#include "window/OpenDocument.h"
#include "window/mesh/EditBase.h"

namespace handwheel {

struct MeshDeviation;

// An open mesh. Its document hides the one of the base: it is the same, known as what it is.
struct OpenMesh : OpenDocument {
  OpenMesh(std::unique_ptr<Document> made, KindUi& of)
      : OpenDocument(std::move(made), of),
        document(static_cast<MeshDocument&>(OpenDocument::document)),
        inspection(document),
        asOpened(document.mesh()) {}

  MeshDocument& document;
  Inspection inspection;
  const HalfEdgeMesh asOpened;               // shares what has not changed since
  std::shared_ptr<MeshDeviation> deviation;  // that is shown; null for none
  Vertex selected = kNone;                   // Inspection::keyOf the selected loop
  bool repaired = false;                     // "Repair all" ran at least once

  std::size_t faceSlots = document.mesh().faceSlots();  // when it was last changed
  FaceSelection newest;  // the faces that the last change added: those of a patch, most often

  // Of the mesh, undo and redo included; as many as when it was last as in its file.
  std::uint64_t changes = 0;
  std::uint64_t changesInFile = 0;
  std::vector<EditBase> bases;  // the newest last
  // touched: as in MeshDocument::meshChanged.
  void meshChanged(const std::vector<Face>& touched) {
    ++changes;
    FaceSelection added;
    for (const Face f : touched)
      if (f >= faceSlots && f < document.mesh().faceSlots()) added.add(f);
    faceSlots = document.mesh().faceSlots();
    newest.dropDead(document.mesh());
    if (!added.empty()) newest = added;
  }
  // Whether the mesh is that of the file, read without loss. What is kept open may differ.
  bool isAsInFile() const { return inFile && document.file().damage.empty() && changes == changesInFile; }
};

}  // namespace handwheel
