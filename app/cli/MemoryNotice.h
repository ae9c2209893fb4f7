// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "cli/Arguments.h"
#include "cli/Interrupt.h"
#include "volume/repair/VolumeRepair.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

namespace handwheel {

// An announcement of the memory and time that a command needs for a volume. If the volume needs more than a quarter of
// the available memory, the command continues only with --yes.
class MemoryNotice {
 public:
  explicit MemoryNotice(const Arguments& arguments);
  // Sets the job that prints the announcement. The job must outlive this object.
  MemoryNotice& during(CommandJob& job);

  // Announces a volume that is about to be made of a surface, with voxels of this edge (mm). Errors:
  // VolumeErrors::NeedsConsent.
  Status begin(const TriangleSoup& surface, double voxel);
  // Announces the repair of a surface by a volume.
  Status begin(const TriangleSoup& surface, const VolumeRepairOptions& options);
  // Announces any volume. bytes: the memory that it needs. seconds: the time that it needs; nothing if unknown. Errors:
  // VolumeErrors::NeedsConsent.
  Status begin(double voxel, double bytes, std::optional<double> seconds);

  // Adds what was predicted for all announced volumes to a report.
  void addTo(nlohmann::ordered_json& report) const;

 private:
  Status begin(const TriangleSoup& surface, double voxel, const VolumeRepairOptions& options, bool isRepair);

  CommandJob* m_job = nullptr;
  bool m_isAgreed, m_isSaid;
  double m_bytes = 0.0;
  std::optional<double> m_seconds;
  std::optional<double> m_triangles;  // triangles of repaired surfaces
};

// The option --yes of commands that make volumes.
OptionSpec consentOption();

}  // namespace handwheel
