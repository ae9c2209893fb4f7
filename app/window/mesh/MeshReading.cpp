// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshReading.h"

#include "document/mesh/MeshSnapshot.h"
#include "mesh/structure/MeshErrors.h"

#include <QFile>

namespace handwheel {

Result<HalfEdgeMesh> readMesh(const DocumentKinds& kinds, const QString& path, Progress progress) {
  const Result<OpenedFile> opened = kinds.open(QFile::encodeName(path).toStdString(), {}, progress);
  if (!opened) return opened.error();
  if (const auto* mesh = dynamic_cast<const MeshSnapshot*>(opened->content.get())) return mesh->mesh.mesh;
  return Error{MeshError::NoTriangles, {}, {}, path.toStdString()};
}

}  // namespace handwheel
