// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshHapticsProvider.h"

#include "haptics/snap/LoopSnapField.h"
#include "haptics/snap/SnapFidelity.h"
#include "tools/carving/VolumeTool.h"
#include "tools/mesh/BoundarySnapFeatures.h"
#include "tools/mesh/MeshContactSurface.h"
#include "tools/mesh/NearFeatures.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/haptics/HapticSession.h"
#include "window/kinds/KindUi.h"
#include "window/mesh/EquivalentCommand.h"
#include "window/mesh/MeshTab.h"
#include "window/tools/ToolHost.h"

#include <QFileInfo>
#include <QJsonArray>
#include <algorithm>
#include <limits>
#include <utility>

namespace handwheel {

namespace {

// Number of snap distances around the tip in which features are gathered: rarely anew, and never many.
constexpr double kReach = 16.0;
constexpr double kNeverAgain = std::numeric_limits<double>::infinity();  // mm

// Points and edges one by one, or the whole rim as one curve, on which a point would stop the hand at every step.
SnapOffer offerOf(const SnapTargets& snapTargets, bool asCurves) {
  const bool isCurve = asCurves && snapTargets.borderEdges;
  return {.vertices = snapTargets.borderPoints && !isCurve,
          .edges = snapTargets.borderEdges && !isCurve,
          .curves = isCurve};
}

}  // namespace

MeshHapticsProvider::MeshHapticsProvider(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_session(parts.haptics),
      m_scene(parts.touch),
      m_tools(parts.tools),
      m_fidelity(parts.fidelity),
      m_voxels(parts.touch),
      m_making(JobRunner::Policy::Latest, parts.pool),
      m_gathering(JobRunner::Policy::Latest, parts.pool),
      m_asCurves(parts.haptics.touch().hasBoundaryCurves) {
  connect(&m_session, &HapticSession::chosenChanged, this, &MeshHapticsProvider::followSession);
  connect(&m_session, &HapticSession::touchChanged, this, &MeshHapticsProvider::followTouch);
  connect(&m_tools, &ToolHost::updated, this, &MeshHapticsProvider::followTool);
  connect(&m_fidelity, &FidelityChoice::changed, this, [this] {
    if (m_snapTargets != SnapTargets()) gather(false);
  });
  connect(&m_session, &HapticSession::sampled, this, &MeshHapticsProvider::followTip);
  connect(&m_session, &HapticSession::recordingStarted, this, [this] {
    m_noted.reset();
    noteSteps();
  });
}

void MeshHapticsProvider::setDocument(MeshTab* document) {
  if (m_document) m_document->document.disconnect(this);
  m_document = document;
  // Queued: when the edit is in the history, where describe() looks for its step.
  if (document)
    connect(&document->document, &MeshDocument::meshChanged, this, &MeshHapticsProvider::edited, Qt::QueuedConnection);
  m_isOpen = m_session.isOpen();
  rebuild(false);
}

void MeshHapticsProvider::followSession() {
  if (m_session.isOpen() == m_isOpen) return;
  m_isOpen = m_session.isOpen();
  if (m_document) rebuild(false);  // else the scene is of another kind of document
}

// After an edit the surface of before is felt until the new one is there: who was outside would else be inside of it.
void MeshHapticsProvider::rebuild(bool isEdit) {
  m_making.cancelAll();
  m_surface.reset();
  if (!isEdit) {
    m_scene.setSurface({}, false);
    dropSnapTargets();
  }
  followVoxels();
  if (!isFelt()) return;
  followTool();
  Job job;
  job.name = tr("Preparing to touch");
  job.work = [this, mesh = m_document->document.mesh()](Progress progress) -> Job::Finish {
    auto surface = std::make_shared<ContactSurface>(contactSurfaceOf(mesh, progress));
    return [this, surface, side = meanSide(mesh)] {
      m_surface = *surface;
      m_side = side;
      setSurface(false);
      if (m_snapTargets.areEverywhere()) gatherNear(false);
    };
  };
  m_making.start(std::move(job));
}

bool MeshHapticsProvider::isFelt() const {
  return m_document && m_document->visible && m_isOpen;
}

// The triangles know nothing of a hole while it is drilled: what is felt is voxels alone, made around the hand.
void MeshHapticsProvider::followVoxels() {
  const auto* const tool = isFelt() ? dynamic_cast<const VolumeTool*>(m_tools.runner().tool()) : nullptr;
  m_voxels.set(tool ? tool->channel() : nullptr, tool ? tool->feelAtDevice() : ClayFeel());
  const bool isOfVoxels = tool != nullptr;
  if (std::exchange(m_isOfVoxels, isOfVoxels) == isOfVoxels) return;
  if (isOfVoxels)
    m_scene.setSurface({}, false);
  else if (m_surface)
    setSurface(false);
}

void MeshHapticsProvider::followTool() {
  followVoxels();
  const Tool* const tool = m_tools.runner().tool();
  const bool mayDraw = isFelt() && m_session.touch().isSnapping;
  const SnapTargets wanted = mayDraw && tool ? tool->snapTargets() : SnapTargets();
  if (wanted == m_snapTargets) return;
  dropSnapTargets();
  m_snapTargets = wanted;
  if (wanted != SnapTargets()) gather(false);
}

// Snapping was switched, or rims are to be felt otherwise; the scene follows the rest by itself.
void MeshHapticsProvider::followTouch() {
  const bool asCurves = m_session.touch().hasBoundaryCurves;
  const bool changes = std::exchange(m_asCurves, asCurves) != asCurves;
  followTool();
  if (changes && m_snapTargets.borderEdges && !m_snapTargets.areEverywhere()) gather(false);
}

void MeshHapticsProvider::dropSnapTargets() {
  m_snapTargets = {};
  m_near.reset();
  m_gathering.cancelAll();
  m_scene.setSnap({}, 0.0, false);
}

// Until the new ones are there, the old draw the tip.
void MeshHapticsProvider::gather(bool isEdit) {
  if (m_snapTargets.areEverywhere()) return gatherNear(isEdit);
  Job job;
  job.name = tr("Preparing to snap");
  job.work = [this, isEdit, offer = offerOf(m_snapTargets, m_asCurves), mesh = m_document->document.mesh(),
              loops = m_document->document.defects().loops](Progress progress) -> Job::Finish {
    auto border = std::make_shared<LoopSnapField>(boundarySnapFeatures(mesh, loops, offer, progress));
    return [this, isEdit, border] {
      const double distance = border->distance(m_fidelity.values());
      m_scene.setSnap(std::move(border->field), distance, isEdit);
    };
  };
  m_gathering.start(std::move(job));
}

// The snap distance is the same all over the mesh: what has hold of the tip is in the next ones as it was in the last.
void MeshHapticsProvider::gatherNear(bool isEdit) {
  const ServoSample* const last = m_session.latest();
  m_near.reset();
  if (!m_surface || !last) return;  // comes with the surface, or with the tip
  const Vec3 position = last->tip.position;
  const double distance = m_fidelity.values().of(snapRadiusSetting()) * m_side;
  Job job;
  job.name = tr("Preparing to snap");
  job.work = [this, isEdit, position, distance, snapTargets = m_snapTargets, surface = *m_surface,
              mesh = m_document->document.mesh()](Progress progress) -> Job::Finish {
    const NearFeatures near = nearFeatures(mesh, surface, snapTargets, position, kReach * distance);
    std::optional<SnapField> field;
    if (!near.features.items().empty()) field.emplace(near.features, progress);
    const bool isSomewhere = near.reach > 0.0;
    const double mayMove = isSomewhere ? std::max(0.5 * (near.reach - distance), 0.25 * near.reach) : kNeverAgain;
    return [this, isEdit, position, distance, mayMove, field = std::move(field)]() mutable {
      m_near = Near{position, mayMove};
      m_scene.setSnap(std::move(field), distance, isEdit);
    };
  };
  m_gathering.start(std::move(job));
}

void MeshHapticsProvider::followTip() {
  const ServoSample* const last = m_session.latest();
  if (!m_snapTargets.areEverywhere() || !last || !m_gathering.isIdle()) return;
  if (!m_near || !((last->tip.position - m_near->position).norm() <= m_near->mayMove)) gatherNear(m_near.has_value());
}

// While it is being made, it is made of a mesh that is no longer there.
void MeshHapticsProvider::edited(const std::vector<Face>& touched) {
  if (!isFelt()) return;
  if (m_surface && isSmallEdit(touched.size())) {
    updateSurface(*m_surface, m_document->document.mesh(), touched);
    setSurface(true);
  } else {
    rebuild(true);
  }
  if (m_snapTargets != SnapTargets()) gather(true);
}

void MeshHapticsProvider::setSurface(bool isEdit) {
  noteSteps();
  if (m_isOfVoxels) return;
  m_scene.setSurface(*m_surface, isEdit, [this] { return describe(); });
}

// Notes the steps that lead to the surface, while a recording runs.
void MeshHapticsProvider::noteSteps() {
  if (!m_document || !m_surface || !m_session.recorder()) return;
  if (m_noted) {
    m_noted->steps = scriptLinesSince(m_document->document, m_noted->base.state);
  } else if (auto path = editPath(*m_document, false)) {
    m_noted = Noted{*path->base, std::move(path->steps), std::nullopt};
  }
}

// Describes the changes of the mesh since the previous note: the first "keep" steps of those from the file remain, and
// then come "steps".
QJsonObject MeshHapticsProvider::describe() {
  QJsonObject note;
  if (!m_noted || !m_noted->steps) {
    note["unknown"] = true;  // an edit that no step describes
    return note;
  }
  const std::vector<std::string>& steps = *m_noted->steps;
  if (m_noted->lastNoted == steps) return note;
  if (!m_noted->lastNoted) note["file"] = QFileInfo(m_noted->base.path).fileName();
  const std::vector<std::string> before = m_noted->lastNoted.value_or(std::vector<std::string>());
  const auto keep = std::mismatch(steps.begin(), steps.end(), before.begin(), before.end()).first;
  note["keep"] = static_cast<qint64>(keep - steps.begin());
  QJsonArray added;
  for (auto step = keep; step != steps.end(); ++step) added.append(QString::fromStdString(*step));
  note["steps"] = added;
  m_noted->lastNoted = steps;
  return note;
}

}  // namespace handwheel
