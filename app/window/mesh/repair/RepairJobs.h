// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/Defects.h"
#include "mesh/repair/Repair.h"
#include "panels/defects/DefectList.h"
#include "tools/mesh/repair/ChangeEffects.h"
#include "tools/mesh/repair/RemainingDefects.h"
#include "window/mesh/HoleFillerCache.h"
#include "window/mesh/HolePreview.h"

#include <QObject>
#include <deque>
#include <map>
#include <optional>
#include <set>

namespace handwheel {

class DocumentTabs;
class FidelityChoice;
class LogModel;
struct Message;
struct DocumentTab;

// Runs changes of a mesh as jobs on snapshots. The result becomes one undo step. If the document was changed while the
// job ran, the result is discarded and the job runs once more.
class RepairJobs : public QObject {
  Q_OBJECT

 public:
  RepairJobs(DocumentTabs& tabs, JobRunner& jobs, LogModel& log, const FidelityChoice& fidelity,
             QObject* parent = nullptr);

  // Fills a hole. prepared: the results of the preview for this hole; may be empty.
  void fill(MeshTab* document, int loop, PreparedFill prepared);
  void repairAll(MeshTab* document);
  void removeDebris(MeshTab* document);
  // Applies a change. "of" names the defects that it fixes; it is empty for the change of a tool. Changes of a document
  // run one after the other.
  void change(MeshTab* document, MeshChange wanted, std::optional<DefectRow> of = std::nullopt);

  // Return true if a fill, a repair or another change is waiting or running, for any document or for the given one.
  bool isWorking() const { return !m_working.empty(); }
  bool isWorkingOn(const DocumentTab* document) const { return m_working.count(document) > 0; }
  // Returns the reason why nothing can be changed now in this document; empty: it can be changed.
  QString obstacle(const MeshTab* document) const;

 signals:
  // Emitted when a hole was filled. key: the loop that was filled. cache: the filler cache, valid for the present
  // document.
  void filled(handwheel::MeshTab* document, handwheel::Vertex key, std::shared_ptr<handwheel::HoleFillerCache> cache);
  void workingChanged();
  // Emitted when a change had no effect. what: the change; why: the reason, as a sentence.
  void changedNothing(const handwheel::MeshTab* document, const QString& what, const QString& why);
  // Emitted when a change had an effect on only some of the sheets. what: the change; how: the affected sheets, and the
  // reason for the others.
  void changedPartly(const handwheel::MeshTab* document, const QString& what, const QString& how);
  // Emitted when a job failed.
  void message(const handwheel::Message& message);

 private:
  enum class Round { First, Second };
  void startFill(MeshTab* document, Vertex key, PreparedFill prepared, Round round);
  struct Request {
    MeshTab* document;
    MeshChange wanted;
    std::optional<DefectRow> of;
    std::uint64_t revision = 0;  // revision of the document to which the change is applied
  };
  void startChange(Request request, Round round);
  void logChange(const MeshTab& document, const MeshChange& done, const QString& text, const QString& command);
  void changeEnded(const DocumentTab* document);
  void dropChanges(const DocumentTab* document);
  void startRepair(MeshTab* document, Round round);
  void changed(const Request& request, const QString& text, const InspectedMesh& after, const ChangeEffects& effects);
  double nearWeld() const;  // value of the setting mesh.near_weld, with which the result of a job is inspected
  bool isStale(MeshTab* document, std::uint64_t revision) const;
  struct Filled {
    FillAttempt attempt;
    FillOptions options;
    std::string step;
  };
  void filledOne(MeshTab* document, Vertex key, const std::shared_ptr<HoleFillerCache>& cache, const Filled& done,
                 const InspectedMesh& after);
  struct Repaired {
    RepairReport report;
    RepairOptions options;
    FidelityValues settings;
    std::string step;
    std::optional<FacePairs> pairs;  // intersecting pairs in the result; none: those before the repair were unknown
    RemainingDefects left;
  };
  void repairedAll(MeshTab* document, const InspectedMesh& after, const Repaired& done);
  void reportCrossings(const MeshTab& document, const IntersectionsChange& crossings);
  void reportStale(const MeshTab& document, const QString& job, Round round);
  void start(const DocumentTab* document, Job job);
  void reportFailure(const DocumentTab* document, const QString& job, const Error& error);
  void ended(const DocumentTab* document);

  DocumentTabs& m_tabs;
  JobRunner& m_jobs;
  LogModel& m_log;
  const FidelityChoice& m_fidelity;
  std::multiset<const DocumentTab*> m_working;                  // the document of each job
  std::map<const DocumentTab*, std::deque<Request>> m_changes;  // the first request of each document is running
};

}  // namespace handwheel
