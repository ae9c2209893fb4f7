// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/WorkpieceSnapshot.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/ProgramTimeline.h"

#include <optional>

namespace handwheel {

// Returns the machine that programs of a workpiece run on. It is the lathe of the workpiece with the tools of its tool
// table and the standard tool (usualSetup()). Program zero is at programZero(). tools: the tools of the lathe; nose:
// the nose radius of the standard tool, mm.
ProgramSetup programSetupFor(const WorkpieceSnapshot& workpiece, const LatheTools& tools, ProgramDialect dialect,
                             double nose);

// The simulated run of a program on a workpiece. It has the tool path, the resulting part, and the part after any of
// the moves. The document is not changed. Objects are immutable and may be used on any thread.
class ProgramTrial {
 public:
  using Pointer = std::shared_ptr<const ProgramTrial>;

  // Runs a program on a workpiece. spacing: distance between the samples of an uncut bar, mm. Errors: the
  // errors of runProgram(), Cancelled.
  static Result<Pointer> run(const WorkpieceSnapshot& workpiece, std::string_view text, ProgramSetup setup,
                             double spacing, Progress progress = {});
  ProgramTrial(const ProgramTrial&) = delete;
  ProgramTrial& operator=(const ProgramTrial&) = delete;

  const ToolPath& path() const { return m_path; }
  const ProgramTimeline& steps() const { return m_steps; }
  const ProgramSetup& setup() const { return m_setup; }
  // Returns the part with the passes of the program after its own passes. Returns null if the program touches nothing.
  const std::shared_ptr<const TurnedPart>& part() const { return m_part; }
  const std::vector<ToolPath::Note>& notes() const { return m_notes; }  // notes of the simulation
  const std::vector<ProgramCollision>& collisions() const { return m_collisions; }
  // Returns the collisions in the form that the manual lathe records. A caller that cuts the part adds them to the
  // workpiece.
  std::vector<LatheCollision> crashes() const;
  std::size_t collisionCount() const { return m_collisionCount; }
  double removed() const { return m_removed; }  // mm³

  // The part at a position on the path.
  struct Moment {
    TurnedProfile profile;
    std::shared_ptr<const PartThreads> threads;  // null: none
  };
  // Returns the part at a position. It is simulated from the nearest stored version, which costs a small part of the
  // whole run. Returns nothing if cancelled.
  std::optional<Moment> at(const ProgramPosition& position, Progress progress = {}) const;

 private:
  ProgramTrial(ToolPath path, ProgramSetup setup)
      : m_path(std::move(path)), m_setup(std::move(setup)), m_steps(m_path) {}
  bool simulate(const WorkpieceSnapshot& workpiece, TurnedPart before, Progress progress);

  struct Version {
    std::size_t done = 0;  // number of finished moves
    TurnedProfile profile;
    ProgramState state;
  };
  ToolPath m_path;
  ProgramSetup m_setup;
  ProgramTimeline m_steps;
  std::vector<Version> m_versions;  // in ascending order of moves; versions share memory pages
  std::shared_ptr<const TurnedPart> m_part;
  std::size_t m_before = 0;  // number of passes before the program
  std::vector<ToolPath::Note> m_notes;
  std::vector<ProgramCollision> m_collisions;
  std::size_t m_collisionCount = 0;
  double m_removed = 0.0;
};

}  // namespace handwheel
