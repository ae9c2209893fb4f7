// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/MeshDocument.h"

#include "document/KeepOpenCommand.h"
#include "document/MeshEditCommand.h"

#include <QFileInfo>
#include <algorithm>

namespace handwheel {

MeshDocument::MeshDocument(QString path, MeshFile file, InspectedMesh mesh, BuildReport build, QObject* parent)
    : QObject(parent),
      m_path(std::move(path)),
      m_format(file.format),
      m_numbers(file.numbers),
      m_damage(std::move(file.damage)),
      m_lost(std::move(file.lost)),
      m_build(std::move(build)),
      m_turnedFaces(m_build.turnedFaces),
      m_mesh(std::move(mesh.mesh)),
      m_defects(std::move(mesh.defects)) {
  connect(&m_history, &QUndoStack::cleanChanged, this, &MeshDocument::fileChanged);
}

// A dying history says that it is clean; nobody may hear it from a document that is half gone.
MeshDocument::~MeshDocument() {
  m_history.disconnect();
}

QString MeshDocument::name() const {
  return QFileInfo(m_path).fileName();
}

void MeshDocument::markSaved(const QString& path, MeshFormat format) {
  m_path = path;
  m_format = format;
  m_history.setClean();
  emit fileChanged();
}

bool MeshDocument::commit(const QString& text, const InspectedMesh& after) {
  MeshDelta delta = MeshDelta::between(m_mesh, after.mesh);
  if (delta.isEmpty()) return false;  // not even pushed as obsolete: that would cost the user the steps to redo
  m_history.push(new MeshEditCommand(*this, text, std::move(delta), after.defects));
  return true;
}

bool MeshDocument::isKeptOpen(const BoundaryLoop& loop) const {
  return m_keptOpen.count(keyOf(loop)) != 0;
}

void MeshDocument::setKeptOpen(const BoundaryLoop& loop, bool keep) {
  if (isKeptOpen(loop) != keep) m_history.push(new KeepOpenCommand(*this, keyOf(loop), keep));
}

void MeshDocument::meshWasChanged(const std::vector<Face>& touched) {
  ++m_revision;
  m_turnedFaces.clear();
  std::copy_if(m_build.turnedFaces.begin(), m_build.turnedFaces.end(), std::back_inserter(m_turnedFaces),
               [this](Face f) { return m_mesh.isLive(f); });
  emit meshChanged(touched);
}

Vertex MeshDocument::keyOf(const BoundaryLoop& loop) const {
  Vertex smallest = kNone;
  for (HalfEdge h : loop.halfEdges) smallest = std::min(smallest, m_mesh.from(h));
  return smallest;
}

}  // namespace handwheel
