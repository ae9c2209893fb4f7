// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/TurnedPartEdit.h"

// Turned parts for tests of documents.
namespace handwheel::test {

inline WorkpieceSnapshot cutTwice() {
  WorkpieceSnapshot workpiece;
  TurningPass pass;
  pass.path = {{21.0, 20.0}, {21.0, 60.0}};
  pass.times = {0.0, 1.0};
  workpiece.part = withPass(workpiece, pass, 0.1);
  pass.path = {{15.0, 70.0}, {26.0, 90.0}};
  workpiece.part = withPass(workpiece, pass, 0.1);
  return workpiece;
}

inline bool isSame(const WorkpieceSnapshot& a, const WorkpieceSnapshot& b) {
  if (!a.part || !b.part) return !a.part && !b.part;
  if (!(a.part->profile == b.part->profile) || a.part->passes.size() != b.part->passes.size()) return false;
  for (std::size_t i = 0; i < a.part->passes.size(); ++i) {
    const TurningPass &p = *a.part->passes[i], &q = *b.part->passes[i];
    if (p.noseRadius != q.noseRadius || p.side != q.side || p.method != q.method || p.resolution != q.resolution ||
        p.isInParts != q.isInParts || p.path != q.path || p.times != q.times)
      return false;
  }
  return true;
}

}  // namespace handwheel::test
