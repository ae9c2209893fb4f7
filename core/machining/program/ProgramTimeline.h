// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ToolPath.h"

namespace handwheel {

// A position on a tool path. It is a number of completed moves and the completed fraction of the next move.
struct ProgramPosition {
  std::size_t done = 0;
  double fraction = 0.0;  // 0…1, completed fraction of the length of the next move
  bool operator==(const ProgramPosition&) const = default;
};

// A tool path that can be stepped through line by line, or by time. The path must outlive the timeline. A step is a
// sequence of moves from one line; a line that runs again is another step. Queries may be made on any thread and cost
// O(log moves).
class ProgramTimeline {
 public:
  explicit ProgramTimeline(const ToolPath& path);

  double duration() const {
    return m_ends.empty() ? 0.0 : m_ends.back();
  }  // s, duration of all moves, without tool changes
  ProgramPosition end() const { return {m_path.moves.size(), 0.0}; }

  double timeAt(const ProgramPosition& position) const;  // s
  ProgramPosition at(double time) const;                 // position at a time (s), after moves that take no time

  // Returns the line of the current move, or of the last one at the end of the path. The line is 0 if the path is
  // empty.
  std::uint32_t lineAt(const ProgramPosition& position) const;
  // Returns the position of the tip, mm, (r, z).
  ProfilePoint tipAt(const ProgramPosition& position) const;
  // Returns the current move, or the last one at the end of the path. The path must have moves.
  const ToolMove& moveAt(const ProgramPosition& position) const;

  // Return the neighbouring ends of steps. next() gives the end of the current step. previous() gives the start of the
  // current step, or of the previous step if the position is at the start.
  ProgramPosition next(const ProgramPosition& position) const;
  ProgramPosition previous(const ProgramPosition& position) const;
  // Returns the end of the first step of a line. If the line does not move the tool, the next line that does is taken;
  // if there is none, the result is the end of the path.
  ProgramPosition afterLine(std::uint32_t line) const;

 private:
  const ToolPath& m_path;
  std::vector<double> m_ends;           // s, end of each move
  std::vector<std::size_t> m_stepEnds;  // number of moves up to the end of each step
};

}  // namespace handwheel
