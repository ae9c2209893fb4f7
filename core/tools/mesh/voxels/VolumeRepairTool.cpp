// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairTool.h"

#include "document/mesh/MeshDocument.h"
#include "tools/mesh/voxels/VolumeRepairChange.h"
#include "tools/mesh/voxels/VolumeRepairOperation.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeMemory.h"
#include "volume/repair/RepairPrediction.h"
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

// Once for each change of the mesh: what is known of it at once, and a job that looks at each triangle.
void VolumeRepairTool::measure() {
  const Defects& known = m_document.defects();
  const Box& box = known.box;
  m_extent = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
  m_usual = box.isEmpty() ? 0.0 : usualVoxel(TriangleSoup{{box.min(), box.max()}, {}});
  m_area = 0.0;
  for (const Component& part : known.components) m_area += part.area;
  m_walls.reset();
  m_job = std::make_shared<const int>();
  m_services.run({QT_TRANSLATE_NOOP("Tool", "Measuring the mesh"),
                  [this, mesh = m_document.mesh(), job = std::weak_ptr(m_job)](const Progress& progress) {
                    if (!progress.cancelled()) measureRepairSpeed();
                    const WallMeasure found =
                        progress.cancelled() ? WallMeasure() : measureForWalls(mesh.compact().soup);
                    return std::function<void()>([this, found, job] {
                      if (job.expired()) return;
                      m_job.reset();
                      m_walls = found;
                      reportUpdated();
                    });
                  }});
}

// Returns the area of the sampled surface, mm². Absent while it is being measured.
std::optional<double> VolumeRepairTool::area() const {
  if (!(m_parameters.wall > 0.0)) return m_area;
  return m_walls ? std::optional(m_walls->areaWith(m_parameters.wall)) : std::nullopt;
}

double VolumeRepairTool::predictedBytes(double sampled) const {
  return predictedRepairBytes(sampled, m_extent, {.voxel = voxelFor(m_parameters, m_usual), .gaps = m_parameters.gaps});
}

void VolumeRepairTool::documentChanged() {
  measure();
}

ToolReply VolumeRepairTool::perform(std::string_view action) {
  if (action == "revert") return ToolReply::Finished;
  const std::optional<double> sampled = area();
  if (action != "commit" || !sampled) return ToolReply::Ignored;
  const double bytes = predictedBytes(*sampled);
  VolumeRepairParameters parameters = m_parameters;
  parameters.isAgreed = needsConsent(bytes);
  const auto start = [commit = m_services.commit, parameters, numbers = m_document.fileNumbers()] {
    commit(volumeRepairChange(parameters, numbers));
  };
  if (parameters.isAgreed)
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
  const bool isMeasured = area().has_value();
  ToolAction commit = actionOf(kVolumeRepairKeys, "commit", m_usual > 0.0 && isMeasured && !isBusy);
  if (!isMeasured) commit.reason = QT_TRANSLATE_NOOP("Tool", "the mesh is being measured");
  if (isBusy) commit.reason = QT_TRANSLATE_NOOP("Tool", "a job that changes this mesh is running");
  return {commit, actionOf(kVolumeRepairKeys, "revert")};
}

std::vector<Property> VolumeRepairTool::settings() const {
  if (!(m_usual > 0.0)) return {};
  Property voxel = volumeRepairOperation().find("voxel")->property;
  voxel.value = voxelFor(m_parameters, m_usual);
  Property wall = volumeRepairOperation().find("wall")->property;
  wall.value = m_parameters.wall;
  Property gaps = volumeRepairOperation().find("close-gaps")->property;
  gaps.id = "close_gaps";
  gaps.value = m_parameters.gaps;
  std::vector<Property> all{std::move(voxel), std::move(gaps), std::move(wall)};
  const std::optional<double> sampled = area();
  if (!sampled) return all;
  Property memory;
  memory.id = "memory";
  memory.label = QT_TRANSLATE_NOOP("Property", "Memory for the voxels (MB)");
  memory.value = std::ceil(predictedBytes(*sampled) / 1e6);
  memory.editable = false;
  Property seconds;
  seconds.id = "seconds";
  seconds.label = QT_TRANSLATE_NOOP("Property", "Time for the repair, about (s)");
  const VolumeRepairOptions options{.voxel = voxelFor(m_parameters, m_usual), .gaps = m_parameters.gaps};
  seconds.value = roundedTo(predictedRepairSeconds(*sampled, m_document.mesh().liveFaceCount(), options));
  seconds.editable = false;
  all.push_back(std::move(memory));
  all.push_back(std::move(seconds));
  return all;
}

void VolumeRepairTool::setSetting(std::string_view id, const PropertyValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (!number || !std::isfinite(*number)) return;
  if (id == "close_gaps") m_parameters.gaps = std::max(0.0, *number);
  if (id == "wall") m_parameters.wall = std::max(0.0, *number);
  if (id == "voxel" && *number > 0.0) m_parameters.voxel = *number;
}

}  // namespace handwheel
