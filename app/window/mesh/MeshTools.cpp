// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshTools.h"

#include "mesh/search/SmoothNormal.h"
#include "tools/MeasureTool.h"
#include "tools/mesh/DecimateTool.h"
#include "tools/mesh/MakeFaceTool.h"
#include "tools/mesh/SelectTool.h"
#include "tools/mesh/SubdivideTool.h"
#include "tools/mesh/TransformTool.h"
#include "tools/mesh/boundary/BoundaryTool.h"
#include "tools/mesh/sculpt/SculptTool.h"
#include "tools/mesh/voxels/VolumeRepairTool.h"
#include "viewport/surface/MeshLayer.h"
#include "window/MemoryQuestion.h"
#include "window/mesh/HolePreview.h"
#include "window/mesh/LoopSelection.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/repair/RepairActions.h"
#include "window/tools/ToolHost.h"

#include <QCoreApplication>
#include <utility>

namespace handwheel {

MeshTools::MeshTools(QWidget* window, ToolHost& host, QThreadPool& pool, const MeshLayer& layer,
                     LoopSelection& selection, HolePreview& preview, RepairActions& actions, RepairJobs& jobs,
                     QObject* parent)
    : QObject(parent),
      m_window(window),
      m_host(host),
      m_layer(layer),
      m_selection(selection),
      m_preview(preview),
      m_actions(actions),
      m_jobs(jobs),
      m_thinking(JobRunner::Policy::Latest, pool) {
  connect(&m_preview, &HolePreview::changed, this, &MeshTools::answer);
  connect(&m_selection, &LoopSelection::changed, this, &MeshTools::followSelection);
  connect(m_actions.preview(), &QAction::toggled, this, [this] { m_host.runner().deliver([] {}); });
  connect(&m_host, &ToolHost::updated, this, &MeshTools::followTool);
  connect(&m_jobs, &RepairJobs::workingChanged, &m_host, &ToolHost::refresh);
}

void MeshTools::setDocument(MeshTab* document) {
  m_thinking.cancelAll();
  m_document = document;
}

void MeshTools::chooseMethod(FillMethod method) {
  if (method == m_preview.method()) return;
  m_preview.choice()->setValid("fill", static_cast<double>(method));
  showChoice();
}

void MeshTools::setPatchHidden(bool isHidden) {
  if (std::exchange(m_isPatchHidden, isHidden) != isHidden) m_host.runner().deliver([] {});
}

void MeshTools::showChoice() {
  if (!runningFillTool()) return m_preview.refresh();
  m_host.runner().setSetting("fill", static_cast<double>(m_preview.method()));  // it asks for a patch
}

std::unique_ptr<Tool> MeshTools::fillTool() {
  FillServices services;
  services.values = m_preview.choice();
  services.faces = [this] { return m_layer.faces(); };
  services.request = [this](const FillRequest& wanted) { request(wanted); };
  services.commit = [this](const BoundaryLoop&, const FillAttempt&) {
    QAction* const fill = m_actions.fill();
    const bool isFree = fill->isEnabled();
    fill->trigger();
    return isFree;
  };
  services.showsPatch = [this] { return m_actions.preview()->isChecked() && !m_isPatchHidden; };
  const Vertex selected = m_document->selected;
  return std::make_unique<FillHoleTool>(m_document->document, std::move(services),
                                        selected == kNone ? std::nullopt : std::optional(selected));
}

std::unique_ptr<Tool> MeshTools::selectTool() {
  return std::make_unique<SelectTool>(m_document->document, services());
}

std::unique_ptr<Tool> MeshTools::boundaryTool() {
  const Vertex selected = m_document->selected;
  return std::make_unique<BoundaryTool>(m_document->document, services(),
                                        selected == kNone ? std::nullopt : std::optional(selected));
}

std::unique_ptr<Tool> MeshTools::makeFaceTool() {
  return std::make_unique<MakeFaceTool>(m_document->document, services());
}

std::unique_ptr<Tool> MeshTools::sculptTool() {
  const auto* select = dynamic_cast<const SelectTool*>(m_host.runner().tool());
  const bool isSelected = select && !select->selection().faces.empty();
  return std::make_unique<SculptTool>(m_document->document, services(),
                                      isSelected ? select->selection().faces : m_document->newest);
}

std::unique_ptr<Tool> MeshTools::measureTool() {
  MeasureServices services;
  services.pick = [this](const Ray& ray) -> std::optional<SurfacePoint> {
    const auto sorted = m_layer.faces();
    const auto hit = sorted ? sorted->firstHit(ray) : std::nullopt;
    if (!hit) return std::nullopt;
    return SurfacePoint{hit->point, smoothNormal(sorted->mesh(), hit->face, hit->point), hit->face};
  };
  services.thickness = [this](const SurfacePoint& at) -> std::optional<WallThickness> {
    const auto sorted = m_layer.faces();
    if (!sorted || at.face >= sorted->mesh().faceSlots() || !sorted->mesh().isLive(at.face)) return std::nullopt;
    return wallThickness(*sorted, at.face, at.point);
  };
  return std::make_unique<MeasureTool>(std::move(services));
}

std::unique_ptr<Tool> MeshTools::decimateTool() {
  return std::make_unique<DecimateTool>(m_document->document, services());
}

std::unique_ptr<Tool> MeshTools::subdivideTool() {
  return std::make_unique<SubdivideTool>(m_document->document, services());
}

std::unique_ptr<Tool> MeshTools::transformTool() {
  return std::make_unique<TransformTool>(m_document->document, services());
}

std::unique_ptr<Tool> MeshTools::volumeRepairTool() {
  return std::make_unique<VolumeRepairTool>(m_document->document, services(),
                                            [window = m_window](double bytes, std::function<void()> start) {
                                              askForMemory(window, bytes, std::move(start));
                                            });
}

std::unique_ptr<Tool> MeshTools::drillTool(const SimulationServices& simulation, MeshDrillTool::OfferVolume offer) {
  return std::make_unique<MeshDrillTool>(m_document->document, services(), simulation, std::move(offer));
}

MeshServices MeshTools::services() {
  MeshServices services;
  services.faces = [this] { return m_layer.faces(); };
  services.cancel = [this] { m_thinking.cancelAll(); };
  services.run = [this](ToolJob wanted) {
    Job job;
    job.name = QCoreApplication::translate("Tool", wanted.name);
    job.work = [this, work = std::move(wanted.work)](Progress progress) -> Job::Finish {
      return [this, finish = work(progress)] { m_host.runner().deliver(finish); };
    };
    m_thinking.start(std::move(job));
  };
  services.commit = [this](MeshChange change) { m_jobs.change(m_document, std::move(change)); };
  services.isBusy = [this] { return m_jobs.isWorkingOn(m_document); };
  return services;
}

const FillHoleTool* MeshTools::runningFillTool() const {
  return dynamic_cast<const FillHoleTool*>(m_host.runner().tool());
}

const BoundaryTool* MeshTools::runningBoundaryTool() const {
  return dynamic_cast<const BoundaryTool*>(m_host.runner().tool());
}

// The preview of the window is the tool's, so the list, the settings and the tool show the same patch.
void MeshTools::request(const FillRequest& request) {
  m_ticket = request.ticket;
  const Vertex key = keyOf(m_document->document.mesh(), request.loop);
  m_preview.setUserBridges(key, request.bridges);
  m_selection.select(m_document->defectList.loopWithKey(key));
  answer();
}

void MeshTools::answer() {
  const FillAttempt* attempt = m_preview.attempt();
  if (!attempt || !runningFillTool()) return;
  m_host.runner().deliver([this, ticket = m_ticket, attempt = *attempt] {
    const_cast<FillHoleTool*>(runningFillTool())->previewReady(ticket, attempt);
  });
}

// Chosen in the list, by key or by undo.
void MeshTools::followSelection() {
  if (const BoundaryTool* boundary = runningBoundaryTool(); boundary && m_document && m_document->selected != kNone) {
    m_host.runner().deliver(
        [boundary, key = m_document->selected] { const_cast<BoundaryTool*>(boundary)->choose(key); });
  }
  const FillHoleTool* tool = runningFillTool();
  if (!tool || !m_document) return;
  const BoundaryLoop* loop = tool->loop();
  const Vertex working = loop ? keyOf(m_document->document.mesh(), *loop) : kNone;
  if (working != m_document->selected) m_host.start(fillTool(), m_document->document);
}

// Dropped in the tool. What works on an edge needs the hole free of a patch, and the keys of the list.
void MeshTools::followTool() {
  m_preview.noteChoice();
  const BoundaryTool* boundary = runningBoundaryTool();
  if (boundary && boundary->isBusy() && m_selection.loop() >= 0) m_selection.select(-1);
  const FillHoleTool* tool = runningFillTool();
  if (tool && m_document && !tool->loop() && m_selection.loop() >= 0) m_selection.select(-1);
}

}  // namespace handwheel
