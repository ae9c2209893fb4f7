// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/force/WorkMaterials.h"
#include "machining/target/TargetProfile.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace handwheel {

// What 'handwheel turn' reports.
struct TurnStatistics {
  double removed = 0.0;                   // mm³
  double force = 0.0, power = 0.0;        // N, kW: the largest
  std::optional<std::size_t> collisions;  // none where they were not looked for
  double time = 0.0;                      // s
  std::optional<double> profileError;     // mm, from a target
  nlohmann::json finish;                  // as finishJson() has it; null where nothing was cut
};

// Adds the time of a pass and its peaks on a part that has this profile before it. spindle: r/min, of a pass that does
// not tell its own. Threads and abrasives are not of Kienzle's law: they have no force here. False: cancelled.
bool addPass(TurnStatistics& figures, const TurnedProfile& profile, const TurningPass& pass,
             const WorkMaterial& material, double spindle, Progress progress);

// As JSON with the keys removed_mm3, max_force_N, max_power_kW, collisions, time_s, profile_error_mm, finish.
std::string statisticsAsJson(const TurnStatistics& figures);
std::string statisticsAsText(const TurnStatistics& figures);

// The target in a file: a drawing as DXF or SVG, or a workpiece. Errors: those of the readers, FormatUnknown.
Result<TargetProfile> readTarget(const std::filesystem::path& path, const DocumentKinds& kinds, Progress progress);

// How far a part is from its target, at most, between the ends of the target, mm. The upper ends of both are put
// together.
double profileError(const TargetProfile& target, const TurnedProfile& part);

}  // namespace handwheel
