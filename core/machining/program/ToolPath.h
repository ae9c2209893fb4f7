// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/BezierArc.h"

#include <cstdint>
#include <string>
#include <vector>

namespace handwheel {

// One move of the tip of a tool, or a dwell, from a program. Points are (r, z) in mm; z = 0 is the zero of the part,
// and r may be negative: beyond the axis.
struct ToolMove {
  enum class Kind : std::uint8_t { Rapid, Feed, Thread, Dwell };

  Kind kind = Kind::Rapid;
  std::int8_t turn = 0;  // 0: straight; 1, -1: an arc, counter-clockwise or clockwise in the plane of z (right), r (up)
  bool isPerRevolution = false;  // of the feed
  bool isSurfaceSpeed = false;   // of the spindle
  std::int8_t spin = 0;          // of the spindle: 1 M3, -1 M4, 0 stopped
  std::uint16_t tool = 0;
  std::uint16_t shape = 0;  // the entry of the table of tools that has its nose; 0: that of the tool
  std::uint32_t line = 0;   // of the program, from 1
  ProfilePoint from{0, 0}, to{0, 0}, centre{0, 0};
  double feed = 0.0;         // mm/min, or mm per revolution; of a thread its pitch along the move
  double spindle = 0.0;      // r/min, or m/min of the surface
  double mostSpindle = 0.0;  // r/min, clamp of the surface speed; 0: none
  double time = 0.0;         // s, that it takes
};

// The angle of an arc, radian, with the sign of its turn: at most a whole turn; 0 of a straight move.
double sweepOf(const ToolMove& move);
double lengthOf(const ToolMove& move);                            // mm
ProfilePoint pointOn(const ToolMove& move, double fraction);      // fraction: 0…1 of its length
ProfilePoint directionOf(const ToolMove& move, double fraction);  // of unit length; 0 where it does not move

// The speed of the spindle at a radius (mm), r/min; at most kMostSpindle where nothing else limits it.
inline constexpr double kMostSpindle = 10'000.0;
double spindleAt(const ToolMove& move, double radius);

// The time that a move takes, s. rapidSpeed: mm/min. A dwell has its own time. Where the spindle stands still, a feed
// per revolution is taken as one at 1 r/min.
double durationOf(const ToolMove& move, double rapidSpeed);

// What a program lets the tool do.
struct ToolPath {
  struct Note {
    std::uint32_t line;
    std::string text;  // English
  };
  std::vector<ToolMove> moves;
  std::vector<Note> notes;   // what was done differently than written
  double time = 0.0;         // s, of all moves and tool changes
  std::uint64_t blocks = 0;  // executed
};

}  // namespace handwheel
