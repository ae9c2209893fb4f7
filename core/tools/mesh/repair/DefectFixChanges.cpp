// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/DefectFixChanges.h"

#include "mesh/repair/CoincidentVertexSeparation.h"
#include "mesh/repair/RepairBudget.h"
#include "mesh/structure/MeshBuilder.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/MeshOperations.h"

namespace handwheel {

MeshChange countedChange(const char* text, std::function<bool(HalfEdgeMesh&, Progress)> work, const char* reason) {
  return explainedChange(
      text, [work = std::move(work)](HalfEdgeMesh& mesh, Progress p) { return work(mesh, p) ? nullptr : kTooLong; },
      reason);
}

std::size_t mostEffort(const HalfEdgeMesh& mesh, std::size_t fixed) {
  return repairBudget(mesh.liveFaceCount(), 1.0, fixed);
}

OperationValues fillingValues(const char* verb, const FillOptions& options) {
  OperationValues values(meshOperation(verb));
  setFillOptions(values, options);
  return values;
}

OperationValues roundingValues(const char* verb, NumberType numbers) {
  OperationValues values(meshOperation(verb));
  setNumbers(values, numbers);
  return values;
}

bool separateNonManifold(HalfEdgeMesh& mesh, NumberType numbers, const std::vector<Vertex>& at, Progress progress) {
  WorkBudget effort = progress.share(mostEffort(mesh));
  if (!separateCoincidentVertices(mesh, numbers, progress.part(0.0, 0.8).within(effort), {}, at).empty())
    relink(mesh, progress.part(0.8, 1.0));
  return !effort.isSpent();
}

MeshChange asFix(MeshChange change, std::string step) {
  change.isFix = true;
  return withStep(std::move(change), std::move(step));
}

}  // namespace handwheel
