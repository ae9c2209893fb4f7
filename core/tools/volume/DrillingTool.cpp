// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/DrillingTool.h"

#include "document/volume/VolumeEdit.h"
#include "tools/ToolProperty.h"
#include "volume/VolumeSampler.h"

#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

DrillSettings settingsFor(const VolumeDocument& document) {
  const auto task = assignedDrilling(document.file().assigned);
  if (!task) return DrillSettings(document.volume()->volume.voxel());
  return {task->tool, task->material, task->spindle, task->feed};
}

}  // namespace

DrillingTool::DrillingTool(VolumeDocument& document, const SimulationServices& services)
    : HandDrill(settingsFor(document)), m_document(document), m_task(assignedDrilling(document.file().assigned)) {
  begin(services);
}

// Returns exactly the setup of the task, if there is one, as the marks compare it.
DrillSetup DrillingTool::setup() const {
  return m_task ? m_task->setup() : HandDrill::setup();
}

std::optional<HandDrill::SurfaceHit> DrillingTool::hitAt(const Ray& ray) const {
  const auto hit = firstHit(m_document.volume()->volume, ray.origin, ray.direction);
  if (!hit) return std::nullopt;
  return SurfaceHit{hit->point, hit->normal};
}

bool DrillingTool::isMaterialAlong(const Vec3& from, const Vec3& displacement) const {
  const VolumeSampler material(m_document.volume()->volume);
  const double length = displacement.norm(), step = std::max(voxelOfPart(), 0.01 * length);
  for (double gone = step; gone < length; gone += step)
    if (material.depthAt(from + gone / length * displacement).depth > 0.0) return true;
  return false;
}

const DrillRecord* DrillingTool::holeBefore() const {
  const auto& holes = m_document.volume()->holes;
  return holes.empty() ? nullptr : holes.back().get();
}

std::unique_ptr<DrillSimulation> DrillingTool::simulation(const std::optional<DrillFeed>& feed) const {
  auto begin = std::make_shared<ClayState>();
  begin->volume = m_document.volume()->volume;
  begin->surface = m_document.volume()->surface;
  begin->mask = m_document.volume()->mask;
  return std::make_unique<DrillSimulation>(std::move(begin), setup(), feed, channel(),
                                           m_task ? std::optional(m_task->plan) : std::nullopt);
}

std::shared_ptr<const KindPreview> DrillingTool::previewOf(const std::shared_ptr<const DrillState>& state) const {
  auto volume = std::make_shared<VolumePreview>();
  volume->state = state;
  return volume;
}

void DrillingTool::settle() {
  if (m_task && isLive()) release();
}

std::vector<Property> DrillingTool::settings() const {
  std::vector<Property> all = HandDrill::settings();
  if (!m_task) return all;
  Property count = numberSetting("tries", QT_TRANSLATE_NOOP("Property", "Tries"), m_document.tryCount(),
                                 Quantity::Number, {0.0, static_cast<double>(TriedHole::kMost)});
  count.editable = false;
  all.push_back(std::move(count));
  return all;
}

void DrillingTool::drop(const DrillState& hole) {
  if (m_task) m_document.addTried(recordOf(hole), hole.figures.forbidden);
}

// An undone hole is no longer shown.
void DrillingTool::documentChanged() {
  if (m_document.volume()->holes.size() != m_lastCount) forgetHole();
  restart();
}

// The edit comes back as documentChanged(), and the next simulation begins there.
void DrillingTool::take(const DrillSimulation&, std::shared_ptr<const DrillRecord> record) {
  const std::shared_ptr<const DrillState> drilled = hole();
  auto after = std::make_shared<VolumeSnapshot>(*m_document.volume());
  after->volume = drilled->volume;
  after->surface = drilled->surface;
  after->layers = nullptr;
  after->holes.push_back(std::move(record));
  m_lastCount = after->holes.size();
  if (m_task) m_document.addTried(*after->holes.back(), drilled->figures.forbidden);
  after->tried = m_document.tried();  // it is the document's value as it stands: no snapshot has to copy it
  m_document.commit(textOf(*drilled), std::make_unique<VolumeEdit>(std::move(after), drilled->changedBlocks));
}

}  // namespace handwheel
