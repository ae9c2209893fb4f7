// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"
#include "tools/mesh/voxels/VolumeRepairOperation.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeMemory.h"
#include "volume/repair/VolumeRepair.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr ToolKey kVolumeRepairKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "repair by volume")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "done")},
};

// To one digit.
double roundedTo(double seconds) {
  const double unit = std::pow(10.0, std::floor(std::log10(seconds)));
  return unit * std::round(seconds / unit);
}

}  // namespace

VolumeRepairTool::VolumeRepairTool(MeshDocument& document, MeshServices services, AskForMemory ask)
    : m_document(document), m_services(std::move(services)), m_ask(std::move(ask)) {
  measure();
}

// O(n); once for each change of the mesh.
void VolumeRepairTool::measure() {
  const TriangleSoup surface = m_document.mesh().compact().soup;
  Box box;
  for (const Vec3& p : surface.points) box.extend(p);
  m_extent = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
  m_measure = measureForWalls(surface);
  m_usual = surface.triangles.empty() ? 0.0 : usualVoxel(surface);
}

double VolumeRepairTool::predictedBytes() const {
  return predictedRepairBytes(m_measure.areaWith(m_wish.wall), m_extent,
                              {.voxel = voxelFor(m_wish, m_usual), .gaps = m_wish.gaps});
}

void VolumeRepairTool::documentChanged() {
  measure();
}

ToolReply VolumeRepairTool::perform(std::string_view action) {
  if (action == "revert") return ToolReply::Finished;
  if (action != "commit") return ToolReply::Ignored;
  const double bytes = predictedBytes();
  VolumeRepairWish wish = m_wish;
  wish.isAgreed = needsConsent(bytes);
  const auto start = [commit = m_services.commit, wish, numbers = m_document.fileNumbers()] {
    commit(volumeRepairChange(wish, numbers));
  };
  if (wish.isAgreed)
    m_ask(bytes, start);
  else
    start();
  return ToolReply::Used;
}

std::span<const ToolKey> VolumeRepairTool::keys() {
  return kVolumeRepairKeys;
}

std::vector<ToolAction> VolumeRepairTool::actions() const {
  const bool isBusy = m_services.isBusy();
  ToolAction commit = actionOf(kVolumeRepairKeys, "commit", m_usual > 0.0 && !isBusy);
  if (isBusy) commit.reason = QT_TRANSLATE_NOOP("Tool", "a job that changes this mesh is running");
  return {commit, actionOf(kVolumeRepairKeys, "revert")};
}

std::vector<Property> VolumeRepairTool::settings() const {
  if (!(m_usual > 0.0)) return {};
  Property voxel = volumeRepairOperation().find("voxel")->property;
  voxel.value = voxelFor(m_wish, m_usual);
  Property memory;
  memory.id = "memory";
  memory.label = QT_TRANSLATE_NOOP("Property", "Memory for the voxels (MB)");
  memory.value = std::ceil(predictedBytes() / 1e6);
  memory.editable = false;
  Property seconds;
  seconds.id = "seconds";
  seconds.label = QT_TRANSLATE_NOOP("Property", "Time for the voxels, about (s)");
  seconds.value = roundedTo(predictedMakingSeconds(m_measure.areaWith(m_wish.wall), voxelFor(m_wish, m_usual)));
  seconds.editable = false;
  Property wall = volumeRepairOperation().find("wall")->property;
  wall.value = m_wish.wall;
  Property gaps = volumeRepairOperation().find("close-gaps")->property;
  gaps.id = "close_gaps";
  gaps.value = m_wish.gaps;
  return {std::move(voxel), std::move(gaps), std::move(wall), std::move(memory), std::move(seconds)};
}

void VolumeRepairTool::setSetting(std::string_view id, const PropertyValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (!number || !std::isfinite(*number)) return;
  if (id == "close_gaps") m_wish.gaps = std::max(0.0, *number);
  if (id == "wall") m_wish.wall = std::max(0.0, *number);
  if (id == "voxel" && *number > 0.0) m_wish.voxel = *number;
}

}  // namespace handwheel
