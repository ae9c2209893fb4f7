// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/MemoryNotice.h"

#include "base/NumberText.h"
#include "process/SystemMemory.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeMemory.h"
#include "volume/repair/RepairPrediction.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

MemoryNotice::MemoryNotice(const Arguments& arguments)
    : m_isAgreed(arguments.has("yes")), m_isSaid(!arguments.has("json")) {}

MemoryNotice& MemoryNotice::during(CommandJob& job) {
  m_job = &job;
  return *this;
}

Status MemoryNotice::begin(const TriangleSoup& surface, double voxel) {
  return begin(surface, voxel, VolumeRepairOptions{.voxel = voxel}, false);
}

Status MemoryNotice::begin(const TriangleSoup& surface, const VolumeRepairOptions& options) {
  return begin(surface, options.voxel, options, true);
}

Status MemoryNotice::begin(const TriangleSoup& surface, double voxel, const VolumeRepairOptions& options,
                           bool isRepair) {
  Box box;
  for (const Vec3& p : surface.points) box.extend(p);
  const double area = surfaceArea(surface);
  if (!(area > 0.0 && std::isfinite(area) && options.voxel > 0.0))
    return Done{};  // the command refuses such an input anyway
  const double bytes = predictedRepairBytes(area, box.sizes(), options);
  if (!isRepair) return begin(voxel, bytes, predictedMakingSeconds(area, voxel));
  measureRepairSpeed();
  m_triangles = predictedRepairWork(area, surface.triangles.size(), options).triangles;
  return begin(voxel, bytes, predictedRepairSeconds(area, surface.triangles.size(), options));
}

Status MemoryNotice::begin(double voxel, double bytes, std::optional<double> seconds) {
  m_bytes += bytes;
  if (seconds) m_seconds = m_seconds.value_or(0.0) + *seconds;
  if (const auto error = consentRefusal(voxel, bytes, m_isAgreed)) return *error;
  if (!m_job || !m_isSaid) return Done{};
  m_job->say("Voxels of " + roundedText(voxel) + " mm need about " + roundedText(bytes / 1e6, 2) + " MB of " +
             roundedText(static_cast<double>(systemMemory()) / 1e6, 3) + " MB available" +
             (seconds ? ", and about " + roundedText(*seconds, 1) + " s." : "."));
  return Done{};
}

void MemoryNotice::addTo(nlohmann::ordered_json& report) const {
  if (m_bytes > 0.0) report["predicted_bytes"] = m_bytes;
  if (m_seconds) report["predicted_s"] = *m_seconds;
  if (m_triangles) report["predicted_triangles"] = std::round(*m_triangles);
}

OptionSpec consentOption() {
  return {"yes", 0, "", "Also make volumes that need more than a quarter of the available memory"};
}

}  // namespace handwheel
