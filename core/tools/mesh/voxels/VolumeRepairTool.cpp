// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"
#include "tools/mesh/voxels/VolumeRepairOperation.h"
#include "volume/SurfaceToVolume.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr ToolKey kVolumeRepairKeys[] = {
    {"commit", "Return", QT_TRANSLATE_NOOP("Tool", "repair by volume")},
    {"revert", "Esc", QT_TRANSLATE_NOOP("Tool", "done")},
};

}  // namespace

VolumeRepairTool::VolumeRepairTool(MeshDocument& document, MeshServices services)
    : m_document(document), m_services(std::move(services)) {
  predict();
}

// O(n); once for each change of the mesh or the voxel.
void VolumeRepairTool::predict() {
  const TriangleSoup surface = m_document.mesh().compact().soup;
  if (!m_isOwn) m_voxel = surface.triangles.empty() ? 0.0 : usualVoxel(surface);
  m_megabytes = m_voxel > 0.0 ? predictedVolumeBytes(surface, m_voxel) / 1e6 : 0.0;
}

void VolumeRepairTool::documentChanged() {
  predict();
}

ToolReply VolumeRepairTool::perform(std::string_view action) {
  if (action == "revert") return ToolReply::Finished;
  if (action != "commit") return ToolReply::Ignored;
  m_services.commit(volumeRepairChange(m_isOwn ? m_voxel : 0.0, m_gaps, m_document.fileNumbers()));
  return ToolReply::Used;
}

std::span<const ToolKey> VolumeRepairTool::keys() {
  return kVolumeRepairKeys;
}

std::vector<ToolAction> VolumeRepairTool::actions() const {
  const bool isBusy = m_services.isBusy();
  ToolAction commit = actionOf(kVolumeRepairKeys, "commit", m_voxel > 0.0 && !isBusy);
  if (isBusy) commit.reason = QT_TRANSLATE_NOOP("Tool", "a job that changes this mesh is running");
  return {commit, actionOf(kVolumeRepairKeys, "revert")};
}

std::vector<Property> VolumeRepairTool::settings() const {
  if (!(m_voxel > 0.0)) return {};
  Property voxel = volumeRepairOperation().find("voxel")->property;
  voxel.value = m_voxel;
  Property memory;
  memory.id = "memory";
  memory.label = QT_TRANSLATE_NOOP("Property", "Memory for the voxels (MB)");
  memory.value = std::ceil(m_megabytes);
  memory.editable = false;
  Property gaps = volumeRepairOperation().find("close-gaps")->property;
  gaps.id = "close_gaps";
  gaps.value = m_gaps;
  return {std::move(voxel), std::move(gaps), std::move(memory)};
}

void VolumeRepairTool::setSetting(std::string_view id, const PropertyValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (!number || !std::isfinite(*number)) return;
  if (id == "close_gaps") m_gaps = std::max(0.0, *number);
  if (id != "voxel" || !(*number > 0.0)) return;
  m_voxel = *number;
  m_isOwn = true;
  predict();
}

}  // namespace handwheel
