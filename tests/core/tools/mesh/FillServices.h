// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/mesh/MeshDocument.h"
#include "tools/mesh/FillHoleTool.h"
#include "tools/mesh/MeshServices.h"

namespace handwheel::test {

// Returns services that immediately do the work of a window's workers. The caller must set tool before the first
// request.
inline FillServices fillServices(MeshDocument& document, FillHoleTool*& tool) {
  FillServices services;
  services.faces = immediateServices(document).faces;
  services.request = [&document, &tool, values = services.values](const FillRequest& request) {
    if (!tool) return;
    FillOptions options = fillOptionsOf(*values);
    options.bridges = request.bridges;
    tool->previewReady(request.ticket, HoleFiller(document.mesh()).propose(request.loop, options));
  };
  services.commit = [&document](const BoundaryLoop& loop, const FillAttempt& attempt) {
    HoleFiller filler(document.mesh());
    filler.accept(loop, attempt.patch);
    return document.commit("Fill hole", inspected(filler.mesh()));
  };
  return services;
}

}  // namespace handwheel::test
