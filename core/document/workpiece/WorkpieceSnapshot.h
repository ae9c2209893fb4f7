// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"
#include "document/workpiece/StockMesh.h"
#include "machining/TurnedSurface.h"
#include "machining/TurningPasses.h"
#include "machining/finish/SurfaceFinish.h"
#include "machining/lathe/LatheCollisions.h"
#include "machining/lathe/LatheSetup.h"
#include "machining/program/ProgramSetup.h"
#include "machining/section/SectionSource.h"
#include "machining/target/TargetProfile.h"

#include <span>
#include <string>

namespace handwheel {

// The part turned from a bar. It has a profile, triangles, and the passes in order.
struct TurnedPart {
  TurnedProfile profile;
  TurnedSurface surface;
  TurningPasses passes;
  SurfaceFinish finish = SurfaceFinish();  // finish of the profile; without samples if unknown

  // Makes the part with its triangles and threads. A profile without a section gets one that is fitted to its samples.
  // chord: the chord tolerance, mm.
  static TurnedPart of(TurnedProfile profile, TurningPasses passes, double chord);

  const std::shared_ptr<const PartThreads>& threads() const { return surface.threads(); }  // null: none
  // Returns the exact half section, without the grooves of threads. The first call after a pass by hand computes it.
  const TurnedSection& section() const { return profile.section()->section(); }
  double volume() const;  // mm³, with the grooves of threads
  // Returns the volume between the samples of the profile, without waiting for the section; mm³.
  double volumeOfSamples() const;
  // Returns the volume of one piece of section().pieces(), with the grooves of threads; mm³.
  double volumeOf(const TurnedSection& piece) const;
  // Returns the pieces that have come off since an earlier state of the part, below which it had material. before: null
  // for an uncut bar.
  std::vector<TurnedSection> partedSince(const TurnedPart* before) const;
};

// The target shape of a part. It consists of the profile in the coordinates of the document, and the name of its
// source.
struct WorkpieceTarget {
  TargetProfile profile;
  std::string source;  // UTF-8
};

// The value of a workpiece document. It has a bar, the turned part, and its target.
struct WorkpieceSnapshot : Snapshot {
  // Limits of the chord tolerance, mm. Within them, the program can show and write the triangles of a bar of any size.
  static constexpr double kLeastChord = 1e-4, kLargestChord = 1e3;

  WorkpieceSnapshot() : mesh(std::make_shared<const StockMesh>(stock, chord)) {}

  StockCylinder stock;
  double chord = 0.01;                            // mm, tolerance of the triangles
  std::string material;                           // name in the user's words, UTF-8
  std::shared_ptr<const StockMesh> mesh;          // triangles of stock and chord; never null
  std::shared_ptr<const TurnedPart> part;         // null: nothing was cut yet
  std::shared_ptr<const LatheSetup> lathe;        // null: the usual setup
  std::shared_ptr<const WorkpieceTarget> target;  // null: no target
  // The tool table of programs, with the tool numbers of LinuxCNC. Null: every tool is the standard tool of
  // usualSetup().
  std::shared_ptr<const ProgramTools> programTools;
  ProgramPost programPost;  // tool post of the machine that programs are for
  // Crashes of the manual lathe and of programs that cut the part, in order, at most LatheRun::kMostCollisions. Undo of
  // a cut does not remove its crash. Null: there are no crashes.
  std::shared_ptr<const std::vector<LatheCollision>> crashes;
};

// Adds crashes up to the limit. Returns true if any was added.
bool addCrashes(WorkpieceSnapshot& workpiece, std::span<const LatheCollision> crashes);

}  // namespace handwheel
