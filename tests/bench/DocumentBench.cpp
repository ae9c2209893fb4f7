// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/Bars.h"
#include "core/proximity/Surfaces.h"
#include "mesh/holes/HoleFiller.h"
#include "support/MeshDocuments.h"
#include "support/MeshShapes.h"

#include <malloc.h>

using namespace handwheel;
using bench::secondsOf;

namespace {

constexpr int kEdits = 100;

bench::Bars bars;

std::size_t heapBytes() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

// Returns a unit sphere of 2 M triangles without those around 100 positions spread over it.
std::unique_ptr<MeshDocument> sphereWithHoles() {
  const test::Surface sphere = test::sphere(500);
  TriangleSoup soup{sphere.points, sphere.triangles};
  for (const Vec3& direction : test::directions(kEdits)) soup = test::withHole(std::move(soup), direction, 0.02);
  return test::meshDocument(soup);
}

// Each hole in a step of its own, as the window does it. What a new search for defects would find is the same without
// that hole, so it is not made. False when a hole is left open.
bool fillAll(MeshDocument& document) {
  HoleFiller filler(document.mesh());
  const std::vector<BoundaryLoop> loops = document.defects().loops;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const FillAttempt attempt = filler.propose(loops[i], {});
    if (attempt.failure != FillFailure::None) return false;
    filler.accept(loops[i], attempt.patch);
    auto defects = std::make_shared<Defects>(document.defects());
    defects->loops.erase(defects->loops.begin());
    document.commit(QStringLiteral("Fill"), InspectedMesh{filler.mesh(), std::move(defects)});
  }
  return true;
}

void undoAndHistory(benchmark::State& state) {
  const std::string historyToAll = "history of 100 filled holes in 2 M triangles, to the document's memory";
  double share = 0.0, undo = 0.0, redo = 0.0;
  for (auto _ : state) {
    auto document = sphereWithHoles();
    const bool isFilled = fillAll(*document);
    QUndoStack& history = *document->history();
    if (!isFilled || history.count() != kEdits) {
      bars.failed(state, historyToAll, "not every hole became a step");
      return;
    }
    undo = secondsOf([&] { history.setIndex(0); });
    redo = secondsOf([&] { history.setIndex(kEdits); });
    state.SetIterationTime(undo);

    // The memory of an object is what its destruction frees.
    const std::size_t all = heapBytes();
    history.clear();
    const std::size_t withoutHistory = heapBytes();
    document.reset();
    share = static_cast<double>(all - withoutHistory) / static_cast<double>(withoutHistory - heapBytes());
  }
  state.counters["undoMs"] = 1e3 * undo / kEdits;
  state.counters["redoMs"] = 1e3 * redo / kEdits;
  state.counters["historyShare"] = share;
  if (!(share > 0.0)) return bars.failed(state, historyToAll, "no memory was counted");
  bars.atMost(historyToAll, 0.05, share);
}

}  // namespace

BENCHMARK(undoAndHistory)->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(1);

int main(int argc, char** argv) {
  return bench::run(argc, argv, bars);
}
