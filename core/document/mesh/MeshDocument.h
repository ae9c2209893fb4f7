// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "document/Document.h"
#include "document/mesh/MeshSnapshot.h"
#include "document/mesh/SubdivisionLevelStore.h"

namespace handwheel {

// Document of a triangle mesh. Jobs take a copy of mesh(), which is cheap, and return their result through commit().
class MeshDocument : public Document {
  Q_OBJECT

 public:
  // The content of the opened file must be a MeshSnapshot.
  explicit MeshDocument(OpenedFile opened, QObject* parent = nullptr);

  const HalfEdgeMesh& mesh() const { return m_mesh; }
  const Defects& defects() const { return *m_defects; }  // defects of the present mesh
  // Faces that were reversed when the file was opened and still exist. The list is empty while the reversal is undone.
  const std::vector<Face>& reversedFaces() const { return m_reversedFaces; }
  // Returns the number of steps at the beginning of the present history that belong to opening the file: 1 if faces
  // were reversed, otherwise 0.
  int openingSteps() const { return m_wasOpenedReversed && !m_hasFileDirections ? 1 : 0; }
  // Returns the faces that were reversed on opening but now have the directions of the file, because the reversal is
  // undone.
  std::vector<Face> facesAsInFile() const;
  // Returns the number type of the coordinates in the present file, or in the container.
  NumberType fileNumbers() const;

  // Returns the levels of the most recently sculpted patch that contains all these faces; null: none. An edit of the
  // patch other than sculpting invalidates them. They are saved with the document, but are not part of the undo
  // history; after undo or redo they are found again by comparing the mesh.
  const PatchLevels* levels(const FaceSelection& faces = {}) const { return m_levels.of(m_mesh, faces); }
  void keepLevels(const PatchLevels& levels) { m_levels.keep(levels); }

  SnapshotPointer snapshot() const override;
  std::vector<Property> properties() const override;

  // The user's choices between speed and accuracy; they apply to later operations. They are not part of the document's
  // value.
  const FidelityValues& fidelity() const { return m_fidelity; }
  void setFidelity(FidelityValues values) { m_fidelity = std::move(values); }

  // The user's choices of mesh.fill_method and mesh.fill_continuity for filling holes of this document one by one. They
  // are saved with the document, but are not part of the undo history.
  const FidelityValues& fillChoice() const { return m_fillChoice; }
  void setFillChoice(FidelityValues values) { m_fillChoice = std::move(values); }

  using Document::commit;
  // Sets the mesh to `after` as one undo step. Returns false, and adds no step, if nothing differs. Takes time
  // proportional to the change. The step is stored according to the setting document.undo_granularity. step: as in
  // UndoCommand::step().
  bool commit(const QString& text, const InspectedMesh& after, std::string step = {});

  // Returns true if the user wants the loop to stay open. The choice can be undone.
  bool isKeptOpen(const BoundaryLoop& loop) const;
  void setKeptOpen(const BoundaryLoop& loop, bool keep);

 signals:
  // Emitted when the mesh has changed. touched: the faces whose triangle was changed, added or removed.
  void meshChanged(const std::vector<handwheel::Face>& touched);
  void keptOpenChanged();

 private:
  friend class MeshEdit;
  friend class ReversalEdit;
  friend class KeepOpenEdit;
  void beginWithReversal(const InspectedMesh& asInFile);
  void meshWasChanged(const std::vector<Face>& touched);

  std::shared_ptr<const BuildReport> m_build;
  NumberType m_numbers;
  std::vector<Face> m_reversedFaces;
  bool m_wasOpenedReversed = false;  // the history began with a ReversalEdit
  bool m_hasFileDirections = false;  // the ReversalEdit is undone
  HalfEdgeMesh m_mesh;
  std::shared_ptr<const Defects> m_defects;
  std::set<Vertex> m_keptOpen;
  SubdivisionLevelStore m_levels;
  FidelityValues m_fidelity;
  FidelityValues m_fillChoice;
};

}  // namespace handwheel
