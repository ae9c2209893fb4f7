// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshServices.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/LocalCrossings.h"
#include "mesh/MeshFidelity.h"

#include <QCoreApplication>

namespace handwheel {

MeshServices immediateServices(MeshDocument& document) {
  MeshServices services;
  struct Index {
    std::uint64_t revision = 0;
    std::shared_ptr<const FaceHierarchy> faces;
  };
  services.faces = [&document, index = std::make_shared<Index>()] {
    if (!index->faces || index->revision != document.revision())
      *index = {document.revision(), std::make_shared<FaceHierarchy>(document.mesh())};
    return index->faces;
  };
  services.run = [](const ToolJob& job) { job.work(Progress())(); };
  services.cancel = [] {};
  services.commit = [&document](const MeshChange& change) {
    HalfEdgeMesh mesh = document.mesh();
    change.apply(mesh, {});
    const auto crossings = change.crossed ? crossingsChange(document.mesh(), mesh) : std::nullopt;
    const double nearWeld = document.fidelity().of(nearWeldSetting());
    document.commit(QCoreApplication::translate("Tool", change.text), inspected(std::move(mesh), nearWeld));
    if (crossings) change.crossed(crossings->fresh);
    change.ended();
  };
  return services;
}

}  // namespace handwheel
