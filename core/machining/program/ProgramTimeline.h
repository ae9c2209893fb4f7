// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ToolPath.h"

namespace handwheel {

// A position on a tool path: a number of completed moves and a fraction. The fraction is the share of the next move.
struct ProgramPosition {
  std::size_t done = 0;
  double fraction = 0.0;  // 0…1, share of the length of the move
  bool operator==(const ProgramPosition&) const = default;
};

// A tool path for stepping: line by line, or by time. The path must outlive it. A step is a run of moves from one line;
// a line that runs again is another step. Any thread; a query costs O(log moves).
class ProgramTimeline {
 public:
  explicit ProgramTimeline(const ToolPath& path);

  double duration() const {
    return m_ends.empty() ? 0.0 : m_ends.back();
  }  // s, duration of all moves, without tool changes
  ProgramPosition end() const { return {m_path.moves.size(), 0.0}; }

  double timeAt(const ProgramPosition& position) const;  // s
  ProgramPosition at(double time) const;                 // at the end of moves that take no time

  // Returns the current line, or the last one; 0 if the path is empty.
  std::uint32_t lineAt(const ProgramPosition& position) const;
  // Returns the position of the tip, mm, (r, z).
  ProfilePoint tipAt(const ProgramPosition& position) const;
  // Returns the current move, or the last one. The path must have moves.
  const ToolMove& moveAt(const ProgramPosition& position) const;

  // Return the end of the current step, and the beginning of it or of the previous one.
  ProgramPosition next(const ProgramPosition& position) const;
  ProgramPosition previous(const ProgramPosition& position) const;
  // Returns the end of the first step of a line, or of the next line that moves the tool; after the last, the end of
  // the path.
  ProgramPosition afterLine(std::uint32_t line) const;

 private:
  const ToolPath& m_path;
  std::vector<double> m_ends;           // s, end of each move
  std::vector<std::size_t> m_stepEnds;  // number of moves up to the end of each step
};

}  // namespace handwheel
