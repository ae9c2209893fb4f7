// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "panels/HoleSettings.h"
#include "window/JobRunner.h"
#include "window/mesh/FillBench.h"

#include <memory>

namespace handwheel {

class FidelityChoice;
class WindowServices;
struct OpenMesh;

// What a fill starts from: the bench, the attempt that the preview showed when there is one, and what that was made by.
struct PreparedFill {
  std::shared_ptr<FillBench> bench;
  std::optional<FillAttempt> attempt;
  std::optional<FillOptions> options = {};
};

// Computes on a worker what filling a hole would give, as soon as the hole is selected.
class HolePreview : public QObject {
  Q_OBJECT

 public:
  HolePreview(QThreadPool& pool, WindowServices& services, const FidelityChoice& fidelity, QObject* parent = nullptr);

  // Asking for what is already shown or on its way changes nothing. loop -1 or no document: no preview.
  void request(OpenMesh* document, int loop);
  void clear() { request(nullptr, -1); }
  // The bridges that the user drew over a loop; none: the program's. They hold for this loop only; the weights of ear
  // cutting for all.
  void setWishes(Vertex key, std::vector<Stitch> stitches, const EarWeights& ears);
  // The same, and nothing is kept for the next request. For when the document changes.
  void forget();

  const PreviewState& state() const { return m_state; }
  const FillAttempt* attempt() const;  // null unless ready or failed

  // What every method makes of the hole that is shown: once the preview is there, and until another hole is.
  void compare();
  const std::vector<MethodTrial>& trials() const { return m_trials; }

  // Hands over the work done for this hole; the fill uses the bench alone. The next request starts anew, unless the
  // bench comes back, now of the document as it is with the patch in it.
  PreparedFill take();
  void giveBack(OpenMesh* document, std::shared_ptr<FillBench> bench);

 signals:
  void changed();
  void compared();

 private:
  void start();
  void finished(std::uint64_t request, FillAttempt attempt);

  WindowServices& m_services;
  const FidelityChoice& m_fidelity;
  Need m_need;  // as long as a preview is wanted
  JobRunner m_runner;
  OpenMesh* m_document = nullptr;
  std::uint64_t m_revision = 0;
  Vertex m_key = kNone;
  int m_loop = -1;
  FillOptions m_options;
  Vertex m_stitched = kNone;  // the key of the loop that has them
  std::vector<Stitch> m_stitches;
  EarWeights m_ears;
  std::uint64_t m_request = 0;
  std::shared_ptr<FillBench> m_bench;
  const OpenMesh* m_benchDocument = nullptr;
  std::uint64_t m_benchRevision = 0;
  std::optional<FillAttempt> m_attempt;
  std::vector<MethodTrial> m_trials;
  PreviewState m_state;
};

}  // namespace handwheel
