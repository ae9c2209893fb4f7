// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/path/OutdatedReasons.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace handwheel {

struct Container;

// The inputs of a path's verification, in the order in which a change is named. Nothing: none of it has changed.
enum class BasisChange { Nothing, Robots, Path, Joints, Bodies, Pairs, Tool, Clearance, Targets, Configurations };

// Its name in files and reports; null: nothing has changed.
const char* keyOf(BasisChange change);

// A digest of each of these (SHA-256, hexadecimal digits), in order, without Nothing.
using BasisDigests = std::array<std::string, 9>;

// Of a path as a whole, as PathMetrics has it.
struct PathMeasures {
  double length = 0.0;    // rad, slides in metres
  double security = 0.0;  // mm
  double manipulability = 0.0;
  bool operator==(const PathMeasures&) const = default;
};

// What the verification of a path found, in brief. Lengths in mm, times in s.
struct PathFindings {
  struct Meeting {
    std::size_t place = 0;  // that the motion leads to, from 0
    std::string link, other;
    double distance = 0.0;  // above 0: they do not meet, but are only this far apart
    bool operator==(const Meeting&) const = default;
  };
  static constexpr std::size_t kMostListed = 5;

  bool isCertified = false;
  std::optional<std::size_t> stopsAt = {};  // the place that a line cannot be followed to
  std::size_t collisions = 0;               // stretches of the path; also those
  std::size_t tooNear = 0;                  // in which nothing meets: it is only nearer than was asked for
  std::vector<Meeting> listed = {};         // the first of them, at most kMostListed
  double clearance = 0.0;                   // that was asked for
  double leastClearance = 0.0;
  double seconds = 0.0;
  std::optional<PathMeasures> measures = {};  // none: stored by a version of the program that did not keep them
  bool hasShapeless = false;                  // links without meshes were left out
  std::set<std::string> robotsMoved = {};
  OutdatedReasons outdated = {};
  // Links and bodies, by their names then, that a person lets touch: nothing is said of these.
  std::vector<std::pair<std::string, std::string>> notChecked = {};

  bool operator==(const PathFindings&) const = default;
};

// What was found of a path, and of what: stored with the cell. It is no more than a note of an earlier session: what is
// exported is verified again.
struct PathProof {
  PathFindings found;
  std::string at;  // when, UTC after ISO 8601
  BasisDigests basis;

  bool operator==(const PathProof&) const = default;
};

using PathProofs = std::map<std::string, PathProof>;  // by the names of the paths

// Writes the proofs of these paths into the container of a cell, and reads them. One that is incomplete, or was found
// by a version of the program that verifies in another way, is left out: then nothing is known of the path.
void writeProofs(const PathProofs& proofs, const std::set<std::string>& paths, Container& container);
PathProofs readProofs(const Container& container);

}  // namespace handwheel
