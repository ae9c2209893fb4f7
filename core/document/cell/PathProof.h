// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/path/OutdatedReasons.h"
#include "document/cell/proof/MissingShape.h"

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace handwheel {

struct Container;

// The inputs of a path's verification, in the order in which their changes are reported. Nothing: no input has changed.
enum class BasisChange {
  Nothing,
  Robots,
  Path,
  Joints,
  Bodies,
  Pairs,
  Tool,
  Clearance,
  Targets,
  Configurations,
  Rates,
};

// Returns the name of the input in files and reports; null for Nothing.
const char* keyOf(BasisChange change);

// A digest of each input (SHA-256, hexadecimal digits), in the order of BasisChange, without Nothing.
using BasisDigests = std::array<std::string, 10>;

// Measures of a whole path, from PathMetrics.
struct PathMeasures {
  double length = 0.0;    // length of the path of the joints that turn, rad
  double security = 0.0;  // mm
  double manipulability = 0.0;
  double slid = 0.0;  // length of the path of prismatic joints, mm
  bool operator==(const PathMeasures&) const = default;
};

// A reason why a path that collides nowhere is not proven free.
struct ProofGap {
  enum class Kind {
    Corner,   // the controller rounds the corner (Fanuc's CNT), and not everything within it is free
    Carried,  // after a line of the program it is not known what the robot carries
    Zone,     // not everything within the zone of a program is free; written programs have a smaller one
  };
  Kind kind = Kind::Corner;
  std::size_t waypoint = 0;  // index of the waypoint, from 0
  std::string text = {};     // the line
  std::size_t line = 0;      // its number in the program that was read
  double kept = 0.0;         // mm, of a zone: its largest proven radius

  bool operator==(const ProofGap&) const = default;
};

// Summary of the verification of a path. Lengths are in mm, times in s.
struct PathFindings {
  struct Meeting {
    std::size_t waypoint = 0;  // Index of the waypoint at the end of the motion, from 0
    std::string link, other;
    double distance = 0.0;  // Above 0: the distance of a pair that does not collide, but is too close
    double needed = 0.0;    // The distance that the proof needs there; 0: unknown, or the pair collides
    bool operator==(const Meeting&) const = default;
  };
  static constexpr std::size_t kMostListed = 5;

  bool isCertified = false;
  std::optional<std::size_t> stopsAt = {};  // Index of the waypoint that a line cannot be followed to
  std::size_t collisions = 0;               // Number of stretches of the path with a collision or too small a distance
  std::size_t tooNear = 0;                  // Number of these stretches without a collision
  std::vector<Meeting> listed = {};         // The first stretches, at most kMostListed
  double clearance = 0.0;                   // Required clearance
  double leastClearance = 0.0;
  double seconds = 0.0;
  std::optional<PathMeasures> measures = {};  // Nothing: stored by a version that computed none
  bool isTouching = false;                    // True if the robot touches something, with a clearance of 0
  std::vector<MissingShape> missing = {};     // Shapes that could not be read
  std::set<std::string> robotsMoved = {};
  OutdatedReasons outdated = {};
  // Links and bodies, by their names at the time of the verification, that may touch and were therefore not checked.
  std::vector<std::pair<std::string, std::string>> notChecked = {};
  std::vector<ProofGap> gaps = {};

  bool operator==(const PathFindings&) const = default;
};

// The findings of a path's verification and digests of its inputs. A proof is stored with the cell as a note of an
// earlier session; exported paths are verified again.
struct PathProof {
  PathFindings found;
  std::string at;  // Time of the verification, UTC according to ISO 8601
  BasisDigests basis;

  bool operator==(const PathProof&) const = default;
};

using PathProofs = std::map<std::string, PathProof>;  // Proofs by the names of the paths

// Write the proofs of paths to the container of a cell, and read them. Proofs that are incomplete, or were made by a
// version of the program with another method of verification, are omitted: their paths count as not verified.
void writeProofs(const PathProofs& proofs, const std::set<std::string>& paths, Container& container);
PathProofs readProofs(const Container& container);

}  // namespace handwheel
