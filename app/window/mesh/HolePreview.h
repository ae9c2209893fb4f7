// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Service.h"
#include "panels/defects/HoleSettings.h"
#include "tools/mesh/operations/FillOperation.h"
#include "window/JobRunner.h"
#include "window/mesh/HoleFillerCache.h"

#include <memory>

namespace handwheel {

class FidelityChoice;
class WindowServices;
struct MeshTab;

// The data that a fill can reuse from the preview. It contains the filler cache unless a worker is using the cache, the
// attempt that the preview showed if there is one, and the options that the user has chosen.
struct PreparedFill {
  std::shared_ptr<HoleFillerCache> cache;
  std::optional<FillAttempt> attempt;
  std::optional<FillOptions> options = {};
};

// Computes a preview of the fill of the selected hole on a worker thread. It starts as soon as the hole is selected.
class HolePreview : public QObject {
  Q_OBJECT

 public:
  HolePreview(QThreadPool& pool, WindowServices& services, const FidelityChoice& fidelity, QObject* parent = nullptr);

  // Requests a preview. Does nothing if the preview is already shown or being computed. If document is null or loop is
  // -1, the preview is removed.
  void request(MeshTab* document, int loop);
  void clear() { request(nullptr, -1); }
  // Sets the bridges that the user drew across a loop; empty: automatic bridges. They apply to this loop only.
  // key: keyOf() of the loop (BoundaryLoops.h).
  void setUserBridges(Vertex key, std::vector<HoleBridge> bridges);
  // Requests the shown preview anew, if the options have changed.
  void refresh() { request(m_document, m_loop); }

  // Sets the document whose options are shown and used. Clears the preview.
  void setDocument(MeshTab* document);
  // The options for filling holes of the document one by one; the tool changes them, and noteChoice() must be called
  // then. They are separate from the fidelity settings, which "Repair all" uses. Method and continuity follow these
  // until the user chooses others for the document.
  const std::shared_ptr<OperationValues>& choice() const { return m_choice; }
  void noteChoice();
  FillMethod method() const { return fillOptionsOf(*m_choice).method; }
  // Clears the preview and drops all cached data, because the document changes.
  void forget();

  const PreviewState& state() const { return m_state; }
  const FillAttempt* attempt() const;  // null: the preview is neither ready nor failed

  // Computes the results of all fill methods for the shown hole when its preview is ready. They are valid until another
  // hole is shown.
  void compare();
  const std::vector<MethodTrial>& trials() const { return m_trials; }

  // Hands over the options and the results for a hole. The fill uses the filler cache exclusively. The next request
  // builds a new cache, unless returnCache() returns this one, updated to the document with the patch.
  PreparedFill take(Vertex key);
  void returnCache(MeshTab* document, std::shared_ptr<HoleFillerCache> cache);

 signals:
  void changed();
  void compared();

 private:
  FillOptions optionsFor(Vertex key) const;
  void followFidelity();
  void start();
  void finished(std::uint64_t request, FillAttempt attempt, const PatchComparison& shape);

  WindowServices& m_services;
  const FidelityChoice& m_fidelity;
  ServiceHandle m_need;  // held while a preview is wanted
  JobRunner m_runner;
  MeshTab* m_shown = nullptr;     // the document in the window
  MeshTab* m_document = nullptr;  // the document of the preview; null: none is wanted
  std::uint64_t m_revision = 0;
  Vertex m_key = kNone;
  int m_loop = -1;
  FillOptions m_options;
  std::shared_ptr<OperationValues> m_choice;
  Vertex m_bridgedLoop = kNone;  // the key of the loop with the user's bridges
  std::vector<HoleBridge> m_bridges;
  std::uint64_t m_request = 0;
  std::shared_ptr<HoleFillerCache> m_fillerCache;
  const MeshTab* m_fillerCacheDocument = nullptr;
  std::uint64_t m_fillerCacheRevision = 0;
  std::optional<FillAttempt> m_attempt;
  std::vector<MethodTrial> m_trials;
  PreviewState m_state;
};

}  // namespace handwheel
