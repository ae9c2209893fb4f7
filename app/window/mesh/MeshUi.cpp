// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshUi.h"

#include "document/UndoCommand.h"
#include "document/formats/step/StepFidelity.h"
#include "document/mesh/KeepOpenEdit.h"
#include "document/mesh/MeshKind.h"
#include "fidelity/Cases.h"
#include "mesh/measure/MeshFidelity.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "panels/defects/DefectModel.h"
#include "panels/defects/DefectsPanel.h"
#include "panels/defects/StateCard.h"
#include "tools/mesh/DecimateTool.h"
#include "tools/mesh/FillHoleTool.h"
#include "tools/mesh/MakeFaceTool.h"
#include "tools/mesh/MeshPreview.h"
#include "tools/mesh/SelectTool.h"
#include "tools/mesh/SubdivideTool.h"
#include "tools/mesh/TransformTool.h"
#include "tools/mesh/boundary/BoundaryTool.h"
#include "tools/mesh/sculpt/SculptTool.h"
#include "tools/mesh/voxels/VolumeRepairTool.h"
#include "viewport/Viewport.h"
#include "viewport/surface/MeshLayer.h"
#include "viewport/surface/VolumeLayer.h"
#include "window/CommandLines.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/kinds/DrillDescriptor.h"
#include "window/mesh/DefectScene.h"
#include "window/mesh/EquivalentCommand.h"
#include "window/mesh/MeshMessages.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/Suggestions.h"
#include "window/tools/ToolHost.h"

#include <QCoreApplication>
#include <QShortcut>
#include <QStackedWidget>
#include <utility>

namespace handwheel {

namespace {
const QString kTransformTool = QStringLiteral("transformTool");
const QString kVolumeRepairTool = QStringLiteral("volumeRepairTool");
}  // namespace

MeshUi::MeshUi(const WindowContext& parts, MeshKind& kind)
    : m_parts(parts),
      m_kind(kind),
      m_layer(std::make_shared<MeshLayer>()),
      m_voxelLayer(std::make_shared<VolumeLayer>(VolumeLayer::Look::Mesh)),
      m_preview(parts.pool, parts.services, parts.fidelity),
      m_search(parts.pool, parts.services),
      m_jobs(parts.tabs, parts.jobs, parts.log, parts.fidelity),
      m_actions(m_selection, m_jobs, m_preview, parts.fidelity, this),
      m_fixPreview(parts.pool, parts.services, *m_actions.preview()),
      m_defectActions(m_selection, m_jobs, m_preview, m_fixPreview, parts.fidelity, this),
      m_shells(parts, kind, *this, m_jobs),
      m_scriptExport(parts, this),
      m_panel(new DefectsPanel(
          {m_actions.repairAll(), m_actions.previous(), m_actions.next(), m_actions.fill(), m_actions.keepOpen(),
           m_actions.preview(), m_defectActions.thickenSheet(), m_defectActions.cutAndClose(), m_defectActions.fix()},
          parts.window)),
      m_deviation(parts, *m_layer, this),
      m_section(parts.viewport, *m_layer, parts.pool),
      m_panels(new QStackedWidget(parts.window)),
      m_scene(new DefectScene(parts.viewport, *m_layer, m_selection, *m_panel->model(), this)),
      m_tools(parts.window, parts.tools, parts.pool, *m_layer, m_selection, m_preview, m_actions, m_jobs),
      m_touch(parts),
      m_show(parts, m_jobs, this) {
  parts.viewport.addLayer(m_layer);
  parts.viewport.addLayer(m_voxelLayer);
  m_panels->setMinimumWidth(264);
  m_panels->addWidget(m_panel);
  m_panels->addWidget(m_deviation.panel());
  connect(&m_section, &SectionView::changed, this, &KindUi::stateChanged);
  connect(&m_deviation, &DeviationView::message, this, &KindUi::message);
  connect(&m_deviation, &DeviationView::shownChanged, this, [this] {
    if (m_panels) m_panels->setCurrentIndex(m_deviation.isShown() ? 1 : 0);
    emit stateChanged();
  });
  connect(&m_show, &RepairDemo::changed, this, &KindUi::stateChanged);
  connect(&m_shells, &ShellActions::message, this, &KindUi::message);
  connect(&m_scriptExport, &ScriptExport::message, this, &KindUi::message);
  connect(&m_jobs, &RepairJobs::message, this, &KindUi::message);
  connectSelection();
  connect(&m_parts.fidelity, &FidelityChoice::changed, this, &MeshUi::followFidelity);
  followFidelity();
  connect(&m_jobs, &RepairJobs::workingChanged, this, &KindUi::stateChanged);
  auto* space = new QShortcut(QKeySequence(Qt::Key_Space), &m_parts.viewport, nullptr, nullptr, Qt::WidgetShortcut);
  connect(space, &QShortcut::activated, m_actions.next(), &QAction::trigger);
}

MeshUi::~MeshUi() {
  setDocument(nullptr);
  m_parts.viewport.removeLayer(*m_voxelLayer);
  m_parts.viewport.removeLayer(*m_layer);
}

void MeshUi::connectSelection() {
  connect(&m_selection, &LoopSelection::changed, this, [this] {
    if (m_panel) m_panel->setSelectedLoop(m_selection.loop());
    emit stateChanged();
  });
  connect(&m_selection, &LoopSelection::hoverChanged, this,
          [this] { m_panel->setHighlightedLoop(m_selection.hovered()); });
  connect(m_panel, &DefectsPanel::loopHovered, &m_selection, &LoopSelection::hover);
  connect(m_panel, &DefectsPanel::loopSelected, &m_selection, &LoopSelection::select);
  connect(m_panel, &DefectsPanel::defectChosen, this, [this](const QModelIndex& index) {
    const auto kind = static_cast<DefectKind>(index.data(DefectModel::KindRole).toInt());
    m_defectActions.choose(index.isValid() ? std::optional(kind) : std::nullopt,
                           index.parent().isValid() ? index.row() : -1);
    m_scene->markChosen(index);
  });
  connect(&m_jobs, &RepairJobs::changedNothing, this,
          [this](const MeshTab* document, const QString& what, const QString& why) {
            emit message(nothingChangedMessage(document->document, what, why));
          });
  connect(&m_jobs, &RepairJobs::changedPartly, this,
          [this](const MeshTab* document, const QString& what, const QString& how) {
            emit message(partlyChangedMessage(document->document, what, how));
          });
  connect(m_panel, &DefectsPanel::defectActivated, m_scene, &DefectScene::showDefect);
  connect(m_panel->settings(), &HoleSettings::methodChanged, &m_tools, &MeshTools::chooseMethod);
  connect(&m_preview, &HolePreview::changed, this, [this] {
    if (!m_panel) return;
    m_panel->settings()->setMethod(m_preview.method());
    m_panel->settings()->showPreview(m_preview.state());
    if (m_panel->settings()->isComparing()) compareMethods();
  });
  connect(&m_fixPreview, &FixPreview::changed, this, &MeshUi::showFix);
  connect(m_panel->settings(), &HoleSettings::compareRequested, this, &MeshUi::compareMethods);
  connect(m_panel->settings(), &HoleSettings::thickeningPointed, this,
          [this](bool isPointed) { m_defectActions.pointAt(m_defectActions.thickenSheet(), isPointed); });
  connect(m_panel->settings(), &HoleSettings::thicknessEdited, &m_defectActions, &DefectActions::setThickness);
  connect(&m_defectActions, &DefectActions::thicknessChanged, this, [this] {
    if (!m_panel || !m_document) return;
    m_panel->settings()->showThickness(m_defectActions.thickness(), m_document->document.displayUnit());
  });
  connect(&m_preview, &HolePreview::compared, this, &MeshUi::compareMethods);
  connect(&m_actions, &RepairActions::showLoopRequested, m_scene, &DefectScene::showLoop);
  connect(&m_actions, &RepairActions::volumeRepairRequested, this, [this] { m_parts.chooseTool(kVolumeRepairTool); });
}

void MeshUi::compareMethods() {
  m_panel->settings()->showTrials(m_preview.trials());
  m_preview.compare();
}

// Jobs ask when they start; the others have to be asked.
void MeshUi::followFidelity() {
  const FidelityValues& values = m_parts.fidelity.values();
  m_kind.setNearWeld(values.of(nearWeldSetting()));
  m_kind.setStepChord(values.of(stepChordSetting()));
  m_layer->setBlockFaces(static_cast<Face>(values.of(blockFacesSetting())));
  m_layer->setCoarseTriangles(static_cast<std::size_t>(values.of(coarseTrianglesSetting())));
  m_panel->settings()->setMethod(m_preview.method());
  m_tools.showChoice();
  for (const auto& open : m_parts.tabs.all()) {
    if (&open->ui == this) static_cast<MeshTab&>(*open).document.setFidelity(values);
  }
}

QWidget* MeshUi::panel() {
  return m_panels;
}

std::unique_ptr<DocumentTab> MeshUi::open(std::unique_ptr<Document> document) {
  auto open = std::make_unique<MeshTab>(std::move(document), *this);
  open->document.setFidelity(m_parts.fidelity.values());
  connect(&open->defectList, &DefectList::changed, this, &KindUi::stateChanged);
  connect(&open->document, &MeshDocument::meshChanged, this,
          [mesh = open.get()](const std::vector<Face>& touched) { mesh->meshChanged(touched); });
  connect(&open->document, &Document::fileChanged, this, [mesh = open.get()] {
    if (!mesh->document.isModified() && mesh->document.history()->isClean()) mesh->changesInFile = mesh->changes;
    noteFile(*mesh);
  });
  connect(open->document.history(), &QUndoStack::indexChanged, &m_scriptExport, &ScriptExport::follow);
  connect(open->document.history(), &QUndoStack::indexChanged, this, [this, mesh = open.get()] { logMark(*mesh); });
  noteFile(*open);
  return open;
}

void MeshUi::opened(DocumentTab& tab) {
  auto doubt = implausibleUnitMessage(static_cast<MeshTab&>(tab).document);
  if (!doubt) return;
  doubt->action = [this, &tab] {
    m_parts.tabs.setCurrent(&tab);
    m_parts.chooseTool(kTransformTool);
  };
  emit message(*doubt);
}

// A loop is marked to be kept open at once, without a job that would log it.
void MeshUi::logMark(const MeshTab& open) {
  const QUndoStack& history = *open.document.history();
  if (history.index() == 0 || history.index() != history.count()) return;  // an undo, most likely
  const auto& done = static_cast<const UndoCommand&>(*history.command(history.index() - 1));
  if (dynamic_cast<const KeepOpenEdit*>(&done.edit()))
    m_parts.log.add(tr("%1: %2").arg(open.document.name(), done.text()), stepCommand(open, done.step()));
}

void MeshUi::setDocument(DocumentTab* document) {
  m_selection.setDocument(nullptr);  // the parts below read it: its loop is one of the document before
  m_document = static_cast<MeshTab*>(document);
  m_preview.setDocument(m_document);
  m_defectActions.setDocument(m_document);  // before the panel chooses none of its rows
  if (m_panel) m_panel->setDefectList(m_document ? &m_document->defectList : nullptr);
  m_scene->setDocument(m_document);
  m_voxelLayer->setVisible(m_document && m_document->visible);
  m_deviation.setDocument(m_document);
  m_section.setDocument(m_document);
  m_touch.setDocument(m_document);
  m_show.setDocument(m_document);
  m_tools.setDocument(m_document);
  m_search.setDocument(m_document);
  m_actions.setDocument(m_document);
  m_shells.setDocument(m_document);
  m_scriptExport.setDocument(m_document);
  m_selection.setDocument(m_document);
}

void MeshUi::refreshVisibility() {
  m_scene->refreshVisibility();
  m_voxelLayer->setVisible(m_document && m_document->visible);
  m_touch.refreshVisibility();
}

void MeshUi::showPreview(const ToolPreview& preview) {
  const MeshPreview onMesh = meshPreviewOf(preview);
  m_layer->setPreviewMesh(onMesh.previewMesh);
  m_layer->setHighlightedFaces(onMesh.highlighted);
  if (std::exchange(m_voxels, onMesh.voxels) != onMesh.voxels) {
    if (m_voxels)
      m_voxelLayer->setVolume(m_voxels->volume, m_voxels->surface);
    else
      m_voxelLayer->setVolume({}, {});
  }
  m_selectedInTool = onMesh.selected;
  selectFaces();
}

// The faces that a fix removes look like the user's selection, and the new ones like a patch.
void MeshUi::showFix() {
  const ChangePreview& fix = m_fixPreview.shown();
  m_layer->setPreview(fix.added.points, fix.added.triangles);
  selectFaces();
  m_tools.setPatchHidden(!fix.isEmpty());
  if (m_panel) m_panel->showFixPreview(m_fixPreview.text());
}

void MeshUi::selectFaces() {
  FaceSelection faces = m_selectedInTool;
  faces.add(m_fixPreview.shown().removed);
  m_layer->setSelectedFaces(faces);
}

QList<QAction*> MeshUi::toolBar() {
  return {m_actions.repairAll(), m_actions.previous(), m_actions.next(), m_actions.fill(), m_actions.keepOpen()};
}

std::vector<StartAction> MeshUi::startActions() const {
  return {{QStringLiteral("openSample"), tr("Open the &sample scan"), tr("Open the sample scan"),
           QStringLiteral("repair"), kScanSample,
           StartTile{QStringLiteral("sampleTile"), QStringLiteral("repair"), tr("Repair a sample scan"),
                     tr("Opens a sample scan with holes. Press N to see the first one, then Enter to close it.")}}};
}

std::vector<ToolDescriptor> MeshUi::tools() {
  ToolDescriptor fill{QStringLiteral("fillTool"),
                      tr("&Holes"),
                      tr("Choose a hole, look at its patch, fill it"),
                      QStringLiteral("hole"),
                      QKeySequence(Qt::Key_H),
                      [this] { return m_tools.fillTool(); },
                      "fill",
                      FillHoleTool::keys()};
  fill.isDefault = true;
  return {
      fill,
      {QStringLiteral("selectTool"), tr("&Select faces"),
       tr("Select faces by click, brush, lasso, connection or angle"), QStringLiteral("select"),
       QKeySequence(Qt::Key_S), [this] { return m_tools.selectTool(); }, "select", SelectTool::keys()},
      {QStringLiteral("boundaryTool"), tr("Hole &boundaries"),
       tr("Move, join and bridge boundary vertices; smooth a boundary; remove islands and peninsulas"),
       QStringLiteral("boundary"), QKeySequence(Qt::Key_B), [this] { return m_tools.boundaryTool(); }, "boundary",
       BoundaryTool::keys()},
      {QStringLiteral("makeFaceTool"), tr("&Make a face"), tr("Make a face from three vertices of open edges"),
       QStringLiteral("make-face"), QKeySequence(Qt::Key_T), [this] { return m_tools.makeFaceTool(); }, "face",
       MakeFaceTool::keys()},
      {QStringLiteral("decimateTool"), tr("&Reduce triangles"),
       tr("Reduce the number of triangles while staying close to the surface"), QStringLiteral("decimate"),
       QKeySequence(Qt::Key_R), [this] { return m_tools.decimateTool(); }, "decimate", DecimateTool::keys()},
      {kVolumeRepairTool, tr("Repair by &volume"),
       tr("Replace everything by the surface of the volume that is enclosed: closed and free of self-intersections, "
          "without details smaller than a voxel"),
       QStringLiteral("kind-volume"), QKeySequence(Qt::SHIFT | Qt::Key_R),
       [this] { return m_tools.volumeRepairTool(); }, "volume-repair", VolumeRepairTool::keys()},
      {QStringLiteral("subdivideTool"), tr("Su&bdivide"),
       tr("Refine the whole mesh by a subdivision scheme, including open edges"), QStringLiteral("subdivide"),
       QKeySequence(Qt::Key_E), [this] { return m_tools.subdivideTool(); }, "subdivide", SubdivideTool::keys()},
      {kTransformTool, tr("&Place"),
       tr("Move, rotate and scale by numbers, or place on a flat face, along the axes or at the origin"),
       QStringLiteral("place"), QKeySequence(Qt::Key_W), [this] { return m_tools.transformTool(); }, "transform",
       TransformTool::keys()},
      {QStringLiteral("sculptTool"), tr("Sc&ulpt"),
       tr("Drag, smooth, inflate and flatten a surface; subdivide a patch and sculpt it at any of its levels"),
       QStringLiteral("sculpt"), QKeySequence(Qt::Key_U), [this] { return m_tools.sculptTool(); }, "sculpt",
       SculptTool::keys()},
      drillToolDescriptor([this] {
        return m_tools.drillTool({m_parts.servoClock, m_parts.services.simulation()},
                                 [this, tab = m_document](const char* reason) { offerVolume(tab, reason); });
      }),
      measureToolDescriptor([this] { return m_tools.measureTool(); })};
}

void MeshUi::offerVolume(MeshTab* tab, const char* reason) {
  emit message(notDrilledMessage(tab->document, QCoreApplication::translate("Tool", reason), [this, tab] {
    m_parts.tabs.setCurrent(tab);
    if (auto* const copy = m_parts.window->findChild<QAction*>(QStringLiteral("copyAs/volume"))) copy->trigger();
  }));
}

std::vector<Hint> MeshUi::hints() {
  return m_parts.tools.hints();
}

Suggestion MeshUi::suggestion() {
  if (m_document && m_show.isRunning()) return m_show.step();
  if (!m_document || m_selection.loop() >= 0 || m_jobs.isWorkingOn(m_document)) return {};
  Suggestion step = suggestionFor(*m_document, {.repairAll = m_actions.repairAll(),
                                                .undoRepair = m_actions.undoRepair(),
                                                .removeDebris = m_actions.removeDebris(),
                                                .oneByOne = m_actions.goOneByOne(),
                                                .thickenSheet = m_defectActions.thickenSheet(),
                                                .reverseBodies = m_defectActions.reverseBodies(),
                                                .resolveIntersections = m_defectActions.resolveIntersections(),
                                                .uniteBodies = m_defectActions.uniteBodies(),
                                                .repairByVolume = m_actions.repairByVolume(),
                                                .showDefects = m_parts.isPanelVisible() ? nullptr : m_parts.showPanel,
                                                .saveAs = m_parts.saveAs});
  step.pointed = [this](const QAction* action, bool isPointed) { m_defectActions.pointAt(action, isPointed); };
  return step;
}

QString MeshUi::statistics() const {
  if (!m_document) return {};
  return tr("%Ln triangle(s)", nullptr, static_cast<int>(m_document->document.mesh().liveFaceCount())) +
         QStringLiteral(" · ") + stateHeadline(m_document->defectList);
}

QString MeshUi::openedText(const DocumentTab& document) const {
  const auto& mesh = static_cast<const MeshTab&>(document);
  const QStringList parts{tr("%n triangle(s)", nullptr, static_cast<int>(mesh.document.mesh().liveFaceCount())),
                          tr("%n hole(s)", nullptr, static_cast<int>(mesh.defectList.holes().size())),
                          tr("%n reversed", nullptr, static_cast<int>(mesh.defectList.count(DefectKind::Flipped)))};
  return tr("Opened %1: %2").arg(mesh.document.name(), parts.join(QStringLiteral(", ")));
}

QString MeshUi::saveCommand(const DocumentTab& open, const QString& path) const {
  const auto& mesh = static_cast<const MeshTab&>(open);
  const bool isCopy = mesh.isAsInFile() && !mesh.document.isModified() && mesh.document.path() != path;
  return isCopy ? convertCommand(mesh.document.path(), path) : editCommand(mesh, path);
}

QString MeshUi::suggestedName(const DocumentTab& document) const {
  const DocumentFile& file = document.document.file();
  if (file.path.empty()) return KindUi::suggestedName(document);
  return file.isContainer ? document.document.path() : repairedName(document.document.path());
}

bool MeshUi::isSettled() const {
  return m_search.isIdle() && m_touch.isSettled() && !m_fixPreview.isWorking() &&
         m_preview.state().kind != PreviewState::Kind::Working;
}

}  // namespace handwheel
