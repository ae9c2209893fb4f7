// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/cell/PathProof.h"
#include "document/cell/RobotCellSnapshot.h"

namespace handwheel {

// Digests of the inputs on which the verification of paths depends. They serve proofs that outlive the session: digests
// are equal if PathBasis (document/cell/path/PathBasis.h) finds no change, also in a cell that was stored and read
// again. The constructor reads all shapes once, which takes about 5 s for a gigabyte. The type is a value, which may be
// used on any thread.
class PathDigests {
 public:
  // former: digests of an earlier state of the cell; data that the cell shares with that state are not read again.
  // Null: none.
  explicit PathDigests(std::shared_ptr<const RobotCellSnapshot> cell, const PathDigests* former = nullptr);

  BasisDigests of(const RobotPath& path) const;

 private:
  std::shared_ptr<const RobotCellSnapshot> m_cell;
  std::string m_robots, m_bodies, m_allowed;
};

// Returns the first input whose digests differ.
BasisChange changeBetween(const BasisDigests& then, const BasisDigests& now);

}  // namespace handwheel
