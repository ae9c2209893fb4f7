// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/repair/RepairChanges.h"

#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/operations/RepairOperation.h"

namespace handwheel {

FillAttempt fillHole(HoleFiller& filler, const BoundaryLoop& loop, const FillOptions& options,
                     const std::optional<FillAttempt>& prepared, Progress progress) {
  FillAttempt attempt = prepared ? *prepared : filler.propose(loop, options, progress);
  if (attempt.failure == FillFailure::None) filler.accept(loop, attempt.patch);
  return attempt;
}

std::string fillStep(Vertex loop, const FillOptions& options) {
  return ScriptLineWriter("fill").word(loopsText({loop})).options(valuesOf(options)).text();
}

MeshChange repairChange(const RepairOptions& options, std::shared_ptr<RepairReport> report) {
  return withStep({repairOperation().title,
                   [options, report = std::move(report)](HalfEdgeMesh& mesh, Progress progress) {
                     RepairReport done = repair(mesh, options, progress);
                     if (report) *report = std::move(done);
                   }},
                  ScriptLineWriter("repair").options(valuesOf(options)).text());
}

}  // namespace handwheel
