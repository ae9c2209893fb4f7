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

// Announces the memory and time that a command needs for a volume. If that is more than a quarter of the memory that is
// left, the command continues only with --yes.
class MemoryNotice {
 public:
  explicit MemoryNotice(const Arguments& arguments);
  // Sets the job that prints the announcement. It must outlive this object.
  MemoryNotice& during(CommandJob& job);

  // Must be called before each volume that is made of a surface, with voxels of this edge, mm. Errors:
  // VolumeErrors::NeedsConsent.
  Status begin(const TriangleSoup& surface, double voxel);
  Status begin(const TriangleSoup& surface, const VolumeRepairOptions& options);
  // Does the same for any volume. seconds: none if unknown.
  Status begin(double voxel, double bytes, std::optional<double> seconds);

  // Adds the predictions for all volumes that were made.
  void addTo(nlohmann::ordered_json& report) const;

 private:
  CommandJob* m_job = nullptr;
  bool m_isAgreed, m_isSaid;
  double m_bytes = 0.0;
  std::optional<double> m_seconds;
};

// The option --yes of commands that make volumes.
OptionSpec consentOption();

}  // namespace handwheel
