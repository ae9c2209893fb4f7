// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/ProgramTrial.h"

#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/finish/FinishMeter.h"
#include "machining/program/ProgramInterpreter.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kVersions = 400;    // kept of a path
constexpr std::size_t kLook = 16;         // moves between two looks at the cancel flag
constexpr double kSimulationShare = 0.5;  // share of the progress; passes and finish are the rest

// Returns the collision in the form that the manual lathe records.
LatheCollision crashOf(const ProgramCollision& collision) {
  LatheCollision crash;
  crash.position = collision.position;
  crash.time = collision.time;
  switch (collision.kind) {
    case ProgramCollision::Kind::Chuck:
      crash.struck = LathePart::Chuck;
      break;
    case ProgramCollision::Kind::RapidInMaterial:
      crash.cause = CrashCause::Rapid;
      break;
    case ProgramCollision::Kind::SpindleAtRest:
      crash.cause = CrashCause::SpindleAtRest;
      break;
    case ProgramCollision::Kind::Contact:
      crash.moving = collision.moving;
      crash.struck = collision.struck;
      break;
  }
  return crash;
}

}  // namespace

ProgramSetup programSetupFor(const WorkpieceSnapshot& workpiece, const LatheTools& tools, ProgramDialect dialect,
                             double nose) {
  const LatheSetup lathe = latheOf(workpiece);
  ProgramSetup setup = usualSetup(dialect, workpiece.stock, lathe.chuck.grip, nose, programAllowance(workpiece));
  const bool drills = lathe.tailstock.fitting == LatheFitting::Drill;
  setup.lathe = ProgramLathe{lathe.chuck, lathe.tailstock, drills ? toolNamed(tools, lathe.tailstock.drill) : nullptr};
  setup.post = workpiece.programPost;
  if (workpiece.programTools) setup.tools = inDialect(*workpiece.programTools, ProgramDialect::LinuxCnc, dialect);
  return setup;
}

Result<ProgramTrial::Pointer> ProgramTrial::run(const WorkpieceSnapshot& workpiece, std::string_view text,
                                                ProgramSetup setup, double spacing, Progress progress) {
  Result<ToolPath> path = runProgram(text, setup, progress.part(0.0, 0.3));
  if (!path) return path.error();
  const std::shared_ptr<ProgramTrial> trial(new ProgramTrial(std::move(path.value()), std::move(setup)));
  if (!trial->simulate(workpiece, partOf(workpiece, spacing), progress.part(0.3, 1.0)))
    return Error{ErrorCode::Cancelled, {}, {}, {}};
  return Pointer(trial);
}

bool ProgramTrial::simulate(const WorkpieceSnapshot& workpiece, TurnedPart before, Progress progress) {
  const std::size_t moves = m_path.moves.size();
  const std::size_t stride = moves / kVersions + 1;
  ProgramState state;
  state.threads = before.threads();
  state.passes = before.passes.size();
  ProgramSimulation simulation(before.profile, m_path, m_setup, state);
  m_versions.push_back({0, before.profile, state});
  m_before = before.passes.size();
  while (simulation.step()) {
    const std::size_t done = simulation.done();
    if (done % stride == 0) m_versions.push_back({done, simulation.part(), simulation.state()});
    if (done % kLook != 0) continue;
    if (progress.cancelled()) return false;
    progress.set(kSimulationShare * static_cast<double>(done) / static_cast<double>(moves));
  }
  if (progress.cancelled()) return false;
  m_notes = simulation.notes();
  m_collisions = simulation.collisions();
  m_collisionCount = simulation.collisionCount();
  std::vector<TurningPass> passes = simulation.takePasses();
  if (passes.empty()) return true;
  const double volumeBefore = before.volume();
  TurningPasses all = before.passes;
  FinishMeter meter(before.profile, before.finish);
  for (std::size_t i = 0; i < passes.size(); ++i) {
    const auto shared = std::make_shared<const TurningPass>(std::move(passes[i]));
    const double each = (1.0 - kSimulationShare) / static_cast<double>(passes.size());
    const double start = kSimulationShare + each * static_cast<double>(i);
    cut(before.profile, shared, static_cast<std::uint32_t>(all.size()), meter, progress.part(start, start + each));
    if (progress.cancelled()) return false;
    all.push_back(shared);
  }
  TurnedPart part = TurnedPart::of(before.profile, std::move(all), workpiece.chord);
  part.finish = meter.finish();
  m_removed = volumeBefore - part.volume();
  m_part = std::make_shared<const TurnedPart>(std::move(part));
  return true;
}

std::vector<LatheCollision> ProgramTrial::crashes() const {
  std::vector<LatheCollision> crashes;
  for (const ProgramCollision& each : m_collisions) {
    crashes.push_back(crashOf(each));
    crashes.back().passes = static_cast<double>(m_before + each.passes);
  }
  return crashes;
}

std::optional<ProgramTrial::Moment> ProgramTrial::at(const ProgramPosition& position, Progress progress) const {
  const auto later = std::upper_bound(m_versions.begin(), m_versions.end(), position.done,
                                      [](std::size_t done, const Version& version) { return done < version.done; });
  const Version& version = *std::prev(later);
  ProgramSimulation simulation(version.profile, m_path, m_setup, version.state, version.done);
  while (simulation.done() < position.done && simulation.step()) {
    if (progress.cancelled()) return std::nullopt;
  }
  if (position.fraction > 0.0) simulation.step(position.fraction);
  return Moment{simulation.part(), simulation.state().threads};
}

}  // namespace handwheel
