// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshFormat.h"
#include "mesh/Defects.h"
#include "mesh/HalfEdgeMesh.h"
#include "mesh/MeshBuilder.h"

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <set>

namespace handwheel {

// A mesh with its file and its undo history. Window thread; jobs take a copy of mesh(), which is cheap, and bring their
// result back through commit().
class MeshDocument : public QObject {
  Q_OBJECT

 public:
  // The file as read, the mesh built from it and what building reported (all done on a worker).
  MeshDocument(QString path, MeshFile file, InspectedMesh mesh, BuildReport build, QObject* parent = nullptr);
  ~MeshDocument() override;

  const HalfEdgeMesh& mesh() const { return m_mesh; }
  const Defects& defects() const { return *m_defects; }       // of the present mesh
  const BuildReport& buildReport() const { return m_build; }  // of the file as it was opened
  // Faces turned over on opening that are still there.
  const std::vector<Face>& turnedFaces() const { return m_turnedFaces; }
  std::uint64_t revision() const { return m_revision; }  // grows with every change, undo and redo included

  QString path() const { return m_path; }
  QString name() const;  // file name
  MeshFormat format() const { return m_format; }
  NumberType numbers() const { return m_numbers; }
  const std::vector<Error>& damage() const { return m_damage; }
  const std::vector<LostAttribute>& lostAttributes() const { return m_lost; }

  QUndoStack* history() { return &m_history; }
  bool isModified() const { return !m_history.isClean(); }
  void markSaved(const QString& path, MeshFormat format);

  // Makes "after" the present mesh as one undo step. False, and no step, when nothing differs. Takes time in proportion
  // to the change.
  bool commit(const QString& text, const InspectedMesh& after);

  // A loop that the user wants open is known by its smallest vertex, which outlives edits elsewhere. Undoable.
  bool isKeptOpen(const BoundaryLoop& loop) const;
  void setKeptOpen(const BoundaryLoop& loop, bool keep);

 signals:
  // touched: the faces whose triangle changed, came or went.
  void meshChanged(const std::vector<handwheel::Face>& touched);
  void keptOpenChanged();
  void fileChanged();  // path, format or clean state

 private:
  friend class MeshEditCommand;
  friend class KeepOpenCommand;
  void meshWasChanged(const std::vector<Face>& touched);
  Vertex keyOf(const BoundaryLoop& loop) const;

  QString m_path;
  MeshFormat m_format;
  NumberType m_numbers;
  std::vector<Error> m_damage;
  std::vector<LostAttribute> m_lost;
  BuildReport m_build;
  std::vector<Face> m_turnedFaces;
  HalfEdgeMesh m_mesh;
  std::shared_ptr<const Defects> m_defects;
  std::set<Vertex> m_keptOpen;
  std::uint64_t m_revision = 1;
  QUndoStack m_history;
};

}  // namespace handwheel
