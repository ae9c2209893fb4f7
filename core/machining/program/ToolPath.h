// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "nurbs/BezierArc.h"

#include <cstdint>
#include <string>
#include <vector>

namespace handwheel {

// One move of the tip of a tool, or a dwell, of a program. Points are (r, z) in mm. z = 0 is the zero of the part; r is
// negative beyond the axis.
struct ToolMove {
  enum class Kind : std::uint8_t { Rapid, Feed, Thread, Dwell };

  Kind kind = Kind::Rapid;
  std::int8_t turn = 0;  // 0: straight; 1: arc, counter-clockwise with z to the right and r up; -1: arc, clockwise
  bool isPerRevolution = false;    // feed is mm per revolution
  bool isSurfaceSpeed = false;     // `spindle` is a surface speed, m/min
  std::int8_t spin = 0;            // spindle direction: 1 M3, -1 M4, 0 stopped
  bool isStoppedByChange = false;  // the spindle stands since M6, which stops it on LinuxCNC
  std::uint16_t tool = 0;
  std::uint16_t shape = 0;  // tool table entry with the nose of the move; 0: the entry of `tool`
  std::uint32_t line = 0;   // line of the program, from 1
  ProfilePoint from{0, 0}, to{0, 0}, centre{0, 0};
  double feed = 0.0;         // mm/min, or mm per revolution; for a thread, its pitch along the move
  double spindle = 0.0;      // r/min, or m/min surface speed
  double mostSpindle = 0.0;  // r/min, limit at a constant surface speed; 0: no limit
  double time = 0.0;         // s, duration
};

// Returns the angle of an arc (rad, at most a whole turn), with the sign of `turn`. The angle of a straight move is 0.
double sweepOf(const ToolMove& move);
double lengthOf(const ToolMove& move);                            // mm
ProfilePoint pointOn(const ToolMove& move, double fraction);      // fraction: 0…1 of the length
ProfilePoint directionOf(const ToolMove& move, double fraction);  // unit vector; 0 if the tool does not move

inline constexpr double kMostSpindle = 10'000.0;  // r/min

// Returns the speed of the spindle (r/min) at a radius (mm). The speed is at most kMostSpindle if the move has no
// limit.
double spindleAt(const ToolMove& move, double radius);

// Returns the duration of a move, s. A dwell has its own time. If the spindle is at rest, the duration of a feed per
// revolution is computed for 1 r/min. rapidSpeed: the speed of rapid moves, mm/min.
double durationOf(const ToolMove& move, double rapidSpeed);

// A piece of a move, between two fractions (0…1) of its length.
struct MovePiece {
  double from = 0.0, to = 1.0;
};
// Returns the time of a piece, s. The time of the whole move must be set. With a feed per revolution and a constant
// surface speed a piece near the axis is made sooner than one farther away.
double timeOf(const ToolMove& move, const MovePiece& piece);
// Returns the mean speed of the spindle during a piece, r/min; 0 if it does not turn. The feed per revolution of a
// piece is its length over its time at this speed.
double spindleOf(const ToolMove& move, const MovePiece& piece);
// Returns the fraction of the length of a move that is complete after a fraction of its time.
double lengthAfter(const ToolMove& move, double fractionOfTime);

// The tool path of a program.
struct ToolPath {
  struct Note {
    std::uint32_t line;
    std::string text;  // English text
  };
  std::vector<ToolMove> moves;
  std::vector<Note> notes;   // deviations from the text of the program
  double time = 0.0;         // s, duration of all moves and tool changes
  std::uint64_t blocks = 0;  // number of executed blocks
};

// Returns true if a line feeds with a spindle that a change of tool has stopped. O(moves).
bool isStoppedByChange(const ToolPath& path, std::uint32_t line);

}  // namespace handwheel
