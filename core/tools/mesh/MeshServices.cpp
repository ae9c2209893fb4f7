// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/MeshServices.h"

#include "document/mesh/MeshDocument.h"
#include "mesh/measure/MeshFidelity.h"
#include "mesh/search/LocalIntersections.h"

#include <QCoreApplication>

namespace handwheel {

const char* reasonOf(const MeshChange& change) {
  const char* const found = change.found ? change.found->load() : nullptr;
  return found ? found : change.reason;
}

MeshChange explainedChange(const char* text, std::function<const char*(HalfEdgeMesh&, Progress)> work,
                           const char* reason) {
  auto found = std::make_shared<std::atomic<const char*>>(nullptr);
  MeshChange change{
      text, [work = std::move(work), found](HalfEdgeMesh& mesh, Progress progress) { *found = work(mesh, progress); },
      reason};
  change.found = std::move(found);
  return change;
}

bool commitChange(MeshDocument& document, const MeshChange& change, Progress progress) {
  HalfEdgeMesh mesh = document.mesh();
  change.apply(mesh, progress.part(0.0, 0.6));
  if (progress.cancelled()) return false;
  const double nearWeld = document.fidelity().of(nearWeldSetting());
  const InspectedMesh after = inspected(std::move(mesh), nearWeld, progress.part(0.6, 1.0));
  if (progress.cancelled()) return false;
  return document.commit(QCoreApplication::translate("Tool", change.text), after, change.step);
}

MeshChange onlyWhere(std::function<bool(const HalfEdgeMesh&)> isAsKnown, MeshChange change) {
  change.apply = [isAsKnown = std::move(isAsKnown), apply = std::move(change.apply)](HalfEdgeMesh& mesh, Progress p) {
    if (isAsKnown(mesh)) apply(mesh, p);
  };
  return change;
}

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
    const HalfEdgeMesh before = document.mesh();
    commitChange(document, change);
    const auto crossings = change.crossed ? intersectionsChange(before, document.mesh()) : std::nullopt;
    if (crossings) change.crossed(crossings->fresh);
    change.ended();
  };
  return services;
}

}  // namespace handwheel
