// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "document/workpiece/CutLoads.h"
#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/force/WorkMaterials.h"
#include "machining/program/ToolPath.h"
#include "machining/target/TargetProfile.h"

#include <filesystem>
#include <nlohmann/json.hpp>

namespace handwheel {

// The figures that 'handwheel turn' reports.
struct TurnStatistics {
  double removed = 0.0;                   // mm³
  double force = 0.0;                     // N, the largest resultant of the three components
  double power = 0.0;                     // kW, the largest at the cut
  DrillPeaks drilling;                    // largest loads of drills
  std::optional<std::size_t> collisions;  // none: not checked
  double time = 0.0;                      // s
  std::vector<ToolPath::Note> warnings;   // warnings of the simulation of a program
  struct Piece {
    double length = 0.0, volume = 0.0;  // mm, mm³
  };
  std::vector<Piece> parted;           // pieces that came off, from the chuck to the free end
  std::optional<double> profileError;  // mm, deviation from a target
  nlohmann::json finish;               // finishJson() of the part; null if nothing was cut
};

// Sets the peak loads of the passes that were cut beyond those of the given workpiece. They are those of the replay, of
// marks and of reports. spindle: the speed for a pass without a recorded speed, r/min. Returns false, with peaks
// that are not numbers, if it took too much work or was cancelled.
bool addLoads(TurnStatistics& figures, const WorkpieceSnapshot& given, const WorkpieceSnapshot& turned,
              const WorkMaterial& material, double spindle, Progress progress);

// Returns the pieces that came off a part since it was `before`. before: null if it was a bar.
std::vector<TurnStatistics::Piece> partedOff(const TurnedPart* before, const TurnedPart& after);

// Returns the figures as JSON with the keys removed_mm3, max_force_N, max_power_kW, max_motor_power_kW, collisions,
// time_s, profile_error_mm, finish; and drilling if something was drilled, parted_off
// if something came off, and warnings if there are any.
std::string statisticsAsJson(const TurnStatistics& figures);
std::string statisticsAsText(const TurnStatistics& figures);

// Reads the target from a file: a drawing as DXF or SVG, or a workpiece. Errors: the errors of the file readers,
// FormatUnknown.
Result<TargetProfile> readTarget(const std::filesystem::path& path, const DocumentKinds& kinds, Progress progress);

// Returns the largest deviation of a part from its target between the ends of the target, mm. The upper ends of the
// part and of the target are aligned.
double profileError(const TargetProfile& target, const TurnedProfile& part);

}  // namespace handwheel
