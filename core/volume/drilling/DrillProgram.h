// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"
#include "base/Result.h"

#include <optional>
#include <string_view>
#include <vector>

namespace handwheel {

// A drilling program: the path of the drill's foremost point over time. The shank is along z. The path is straight
// between waypoints.
struct DrillProgram {
  struct Waypoint {
    double time = 0.0;        // s
    Vec3 tip = Vec3::Zero();  // mm
  };
  std::vector<Waypoint> waypoints;  // at least one
  std::optional<double> spindle;    // r/min

  static constexpr double kRapid = 50.0;           // mm/s, speed of G0 and of the rapid moves in cycles
  static constexpr double kPeckClearance = 0.254;  // mm above the last depth, where the next peck starts (LinuxCNC)
  static constexpr std::size_t kMostWaypoints = 1'000'000;
};

// Reads a drilling program (RS274/NGC as in LinuxCNC). It may contain G0 and G1; the cycles G81, G82 (with a dwell P,
// s) and G83 (in pecks of Q) with R, which apply until G80; G98 and G99 (return to the initial height, or to R); G4 P;
// X, Y, Z in mm (G21), absolute (G90), with F in mm/min (G94); S, M3, M5, M30 and M2; comments. The first move must
// specify all three axes, as it is the start position of the drill.
//
// All other words are refused, so nothing that would change the path is skipped. Errors, with the line:
// NumberMalformed, VolumeErrors::ProgramWord {word}, ProgramLacks {missing word, word that needs it}, ProgramValue
// {word, requirement}, ProgramTooLong {most moves}; VolumeErrors::ProgramMovesNothing.
Result<DrillProgram> readDrillProgram(std::string_view text);

}  // namespace handwheel
