// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ScriptReplay.h"
#include "tools/mesh/BoundaryLoopText.h"
#include "tools/mesh/repair/RepairChanges.h"

namespace handwheel::test {

// A model that is edited in the same manner as in the window.
struct Work {
  TriangleSoup soup;
  std::unique_ptr<MeshDocument> document;

  explicit Work(TriangleSoup of) : soup(std::move(of)), document(test::meshDocument(soup)) {}
  MeshServices services() const { return immediateServices(*document); }
  int steps() const { return document->history()->index() - document->openingSteps(); }
  std::string step(int i = 0) const { return scriptLinesSince(*document).value().at(static_cast<std::size_t>(i)); }
  // Returns an empty string if exactly count steps were made and they can be replayed.
  std::string check(int count = 1) const {
    return steps() == count ? test::replayed(soup, *document) : "steps: " + std::to_string(steps());
  }
  Vertex key(std::size_t loop) const { return keyOf(document->mesh(), document->defects().loops.at(loop)); }

  // Fills a hole as RepairJobs does.
  FillFailure fill(std::size_t id, FillOptions options = {}) {
    options.numbers = document->fileNumbers();
    const BoundaryLoop loop = document->defects().loops.at(id);
    HoleFiller filler(document->mesh());
    const FillFailure failure = fillHole(filler, loop, options, std::nullopt).failure;
    if (failure != FillFailure::None) return failure;
    document->commit("Fill", inspected(filler.mesh()), fillStep(keyOf(document->mesh(), loop), options));
    return FillFailure::None;
  }
  void repairAll(RepairOptions options) {
    options.fill.numbers = document->fileNumbers();
    options.keepOpen = keptLoops(*document);
    commitChange(*document, repairChange(options));
  }
};

}  // namespace handwheel::test
