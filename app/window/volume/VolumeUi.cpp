// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/VolumeUi.h"

#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeKind.h"
#include "document/volume/VolumeMaking.h"
#include "document/volume/exercise/DrillingSubject.h"
#include "panels/MessageBar.h"
#include "theme/Theme.h"
#include "tools/carving/HandDrill.h"
#include "tools/volume/ClayTool.h"
#include "tools/volume/DrillingTool.h"
#include "viewport/Viewport.h"
#include "viewport/surface/VolumeLayer.h"
#include "volume/VolumeFidelity.h"
#include "window/JobRunner.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/kinds/DrillDescriptor.h"
#include "window/tools/ToolHost.h"
#include "window/volume/ClayLayersView.h"
#include "window/volume/DrillView.h"
#include "window/volume/RemeshAction.h"
#include "window/volume/ReshapeActions.h"
#include "window/volume/StampAction.h"
#include "window/volume/VoxelizeQuestion.h"
#include "window/volume/segmentation/Segmentation.h"

#include <QLocale>
#include <utility>

namespace handwheel {

VolumeUi::VolumeUi(const WindowContext& window, VolumeKind& kind)
    : RigidPartsUi(window, {"Volume"}),
      m_kind(kind),
      m_volumeLayer(std::make_shared<VolumeLayer>()),
      m_segmentation(new Segmentation(window, this)),
      m_layers(new ClayLayersView(window, this)),
      m_drillView(new DrillView(window, this)),
      m_reshape(new ReshapeActions(window, this)),
      m_remesh(new RemeshAction(window, this)),
      m_stamp(new StampAction(window, this)),
      m_voxelize(new VoxelizeQuestion(window.window, window.jobs, kind, this)),
      m_touch(window.touch) {
  connect(m_segmentation, &Segmentation::message, this, &VolumeUi::message);
  connect(m_voxelize, &VoxelizeQuestion::message, this, &KindUi::message);
  setFelt(false);  // through the depths of the volume, not through triangles
  window.viewport.addLayer(m_volumeLayer);
  connect(&window.tools, &ToolHost::updated, this, &VolumeUi::followTool);
  connect(m_layers, &ClayLayersView::message, this, &KindUi::message);
  connect(m_drillView, &DrillView::message, this, &KindUi::message);
  connect(m_reshape, &ReshapeActions::message, this, &KindUi::message);
  connect(m_remesh, &RemeshAction::message, this, &KindUi::message);
  connect(m_stamp, &StampAction::message, this, &KindUi::message);
  connect(&window.fidelity, &FidelityChoice::changed, this, &VolumeUi::followFidelity);
  followFidelity();
}

VolumeUi::~VolumeUi() {
  parts().viewport.removeLayer(*m_volumeLayer);
}

const VolumeSnapshot& VolumeUi::volume() const {
  return *static_cast<const VolumeDocument&>(document()->document).volume();
}

void VolumeUi::setDocument(DocumentTab* opened) {
  if (document()) document()->document.disconnect(this);
  m_live.reset();
  m_drawn.reset();
  m_volumeLayer->setVolume({}, {});
  if (opened) {
    const VolumeSnapshot& content = *static_cast<const VolumeDocument&>(opened->document).volume();
    m_volumeLayer->setVisible(opened->visible);
    m_volumeLayer->setVolume(content.volume, content.surface, content.mask);
    m_drawn = static_cast<const VolumeDocument&>(opened->document).volume();
  }
  const QString reason = opened && static_cast<const VolumeDocument&>(opened->document).isToBeDrilled()
                             ? tr("This volume is to be drilled, not shaped")
                             : QString();
  parts().viewport.setOfPatient(opened && static_cast<const VolumeDocument&>(opened->document).scan());
  m_reshape->setDocument(opened, reason);
  m_remesh->setDocument(opened);
  m_stamp->setDocument(opened);
  RigidPartsUi::setDocument(opened);
  m_still = std::make_shared<ClayChannel>();
  if (opened) connect(&opened->document, &Document::changed, this, &VolumeUi::showVolume);
  if (opened) offerStill();
  m_segmentation->setDocument(opened);
  m_layers->setDocument(reason.isEmpty() ? opened : nullptr, reason);
  followTool();
}

void VolumeUi::refreshVisibility() {
  RigidPartsUi::refreshVisibility();
  if (document()) m_volumeLayer->setVisible(document()->visible);
  followTool();
}

void VolumeUi::forget(DocumentTab* tab) {
  m_segmentation->forget(tab);
}

void VolumeUi::showVolume() {
  if (!document()) return;
  std::shared_ptr<const void> drawn = m_live;
  if (!drawn) drawn = static_cast<const VolumeDocument&>(document()->document).volume();
  if (std::exchange(m_drawn, drawn) == drawn) return;  // the segment of its scan was changed
  offerStill();
  if (m_live) return m_volumeLayer->setVolume(m_live->volume, m_live->surface, m_live->mask);
  m_volumeLayer->setVolume(volume().volume, volume().surface, volume().mask);
}

// Publishes the state for the haptic device while no tool runs. Only this thread writes it.
void VolumeUi::offerStill() {
  auto state = std::make_shared<ClayState>();
  state->volume = volume().volume;
  m_still->patch.write({std::move(state)});
}

void VolumeUi::showPreview(const ToolPreview& preview) {
  RigidPartsUi::showPreview(preview);
  const auto* const clay = dynamic_cast<const VolumePreview*>(preview.ofKind.get());
  const std::shared_ptr<const ClayState> live = clay ? clay->state : nullptr;
  if (std::exchange(m_live, live) == live) return;
  showVolume();
  m_drillView->follow();
}

// The volume has its own layer. Of an exercise the planned path and the forbidden region are shown beside it.
DisplayModel VolumeUi::displayed(const Document& document) const {
  const AssignedExercise& assigned = document.file().assigned;
  if (std::exchange(m_plannedBy, assigned.description) == assigned.description) return m_planned;
  const auto task = assignedDrilling(assigned);
  m_planned = task ? DisplayModel{planParts(task->plan)} : DisplayModel();
  return m_planned;
}

// The clay is felt through the simulation of its tool, or as it is.
void VolumeUi::followTool() {
  m_drillView->follow();
  m_reshape->followTool();
  const auto* const tool = dynamic_cast<const VolumeTool*>(parts().tools.runner().tool());
  const bool isFelt = document() && document()->visible;
  const std::shared_ptr<ClayChannel> channel = !isFelt ? nullptr : tool ? tool->channel() : m_still;
  m_touch.set(channel, tool ? tool->feelAtDevice() : ClayFeel());
}

QList<QAction*> VolumeUi::menu() {
  QList<QAction*> all{m_segmentation->action(), m_layers->action()};
  auto* const line = new QAction(this);
  line->setSeparator(true);
  all << line << m_reshape->all() << m_stamp->action() << m_remesh->action();
  return all;
}

bool VolumeUi::isSettled() const {
  return RigidPartsUi::isSettled() && m_segmentation->isSettled() && m_remesh->isSettled();
}

bool VolumeUi::askToCopy(const Document& from, std::function<void(MakeOfSurface)> start) {
  const bool isDrilling = dynamic_cast<const HandDrill*>(parts().tools.runner().tool()) != nullptr;
  m_voxelize->ask(from, isDrilling ? VoxelizeSettings::Purpose::Drilling : VoxelizeSettings::Purpose::Any,
                  std::move(start));
  return true;
}

std::vector<StartAction> VolumeUi::startActions() const {
  return {{QStringLiteral("newVolume"),
           tr("New &clay"),
           tr("Start with a ball of clay to be shaped by hand"),
           panelIcon(),
           {},
           StartTile{QStringLiteral("clayTile"), panelIcon(), tr("Shape clay"),
                     tr("Starts with a ball of clay. Add, carve and smooth it by hand.")}},
          {QStringLiteral("newSkull"),
           tr("New &skull"),
           tr("Start with a synthetic skull to be drilled, not that of a patient"),
           panelIcon(),
           {},
           {},
           true}};
}

void VolumeUi::followFidelity() {
  m_kind.setPieceCells(pieceCellsOf(parts().fidelity.values().of(volumePiecesSetting())));
}

// Making the skull takes a second.
void VolumeUi::begin(const QString&) {
  Job job;
  job.name = tr("Making the skull");
  job.owner = this;
  // The window may be destroyed while the worker runs, so the worker only uses the kind, which outlives it.
  job.work = [this, &kind = m_kind](Progress) {
    OpenedFile opened{&kind, {}, skullContent(kind.pieceCells())};
    opened.file.id = newDocumentId();
    return Job::Finish([this, opened]() mutable { parts().openDocument(std::move(opened)); });
  };
  parts().jobs.start(std::move(job));
}

std::vector<ToolDescriptor> VolumeUi::tools() {
  const auto make = [this]() -> std::unique_ptr<Tool> {
    const SimulationServices services{parts().servoClock, parts().services.simulation()};
    auto tool =
        std::make_unique<ClayTool>(static_cast<VolumeDocument&>(document()->document), services, m_stamp->services());
    tool->whenRefused([this] { refuseStroke(); });
    return tool;
  };
  const auto drill = [this]() -> std::unique_ptr<Tool> {
    const SimulationServices services{parts().servoClock, parts().services.simulation()};
    return std::make_unique<DrillingTool>(static_cast<VolumeDocument&>(document()->document), services);
  };
  return {{QStringLiteral("clayTool"), tr("Shape &clay"), tr("Add, carve, smooth and move clay by hand"),
           QStringLiteral("sculpt"), QKeySequence(Qt::SHIFT | Qt::Key_U), make, "clay", ClayTool::keys()},
          drillToolDescriptor(drill),
          m_reshape->tool(),
          measureParts()};
}

void VolumeUi::refuseStroke() {
  if (!static_cast<const VolumeDocument&>(document()->document).isToBeDrilled()) return m_layers->refuse();
  Message refusal{Message::Weight::Warning, tr("This volume is to be drilled, not shaped"),
                  tr("It is work on an exercise, which measures what the drill takes and nothing else."),
                  tr("Choose Drill (Shift+D).")};
  refusal.about = &document()->document;
  emit message(refusal);
}

Suggestion VolumeUi::suggestion() {
  if (!document()) return {};
  const SparseVolume& shown = volume().volume;
  return {panelIcon(), themeColours(currentTheme()).accent, tr("Volume"),
          tr("%1 mm³ in voxels of %2 mm. Its surface is closed.")
              .arg(QLocale().toString(shown.enclosed(), 'g', 6), QLocale().toString(shown.voxel(), 'g', 4)),
          panelActions()};
}

QString VolumeUi::statistics() const {
  if (!document()) return {};
  return tr("%1 triangles").arg(QLocale().toString(static_cast<qulonglong>(volume().surface.triangleCount())));
}

QString VolumeUi::openedText(const DocumentTab& opened) const {
  return tr("Opened %1: a volume").arg(opened.document.name());
}

}  // namespace handwheel
