// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/section/TurnedSection.h"

namespace handwheel {

// A move that may be cut in pieces.
struct WholeMove {
  WholeMove(const ProfileSegment& written) : path(written), end(written.to) {}
  WholeMove(const ProfileSegment& written, const ProfilePoint& inwardEnd) : path(written), end(inwardEnd) {}

  ProfileSegment path;
  ProfilePoint end;  // mm, the point at which the tool ends to go inward, in this or a later move
};

// Returns true if a nose with edges goes inward in a direction, more steeply than 45°.
bool goesInward(const TurningPass& how, const ProfilePoint& direction);
// Returns the first point of a move from which the tool no longer goes inward, if it does at the start; otherwise
// nothing. The point is the end of the move if it goes inward there.
std::optional<ProfilePoint> inwardEnd(const TurningPass& how, const ProfileSegment& move);
// Returns WholeMove::end of each of consecutive moves. O(moves).
std::vector<ProfilePoint> inwardEnds(const TurningPass& how, std::span<const ProfileSegment> moves);

// Subtracts the area that the tool of a pass sweeps in one move. The new boundary is marked with the number of the
// pass. Returns nothing if the section could not be cut (TurnedSection::subtract()). Passes of threads and of control
// points (TurningMethod::Poles) remove nothing here.
//
// A lathe tool removes its own area. A nose without a body removes also what lies outward of it or, in a bore, between
// it and the axis, because its shank comes from there. If it has edges (TurningPass::edges) and moves inward more
// steeply than 45°, it removes what its trailing edge sweeps as well, as in facing: all as far as the next plane
// without material. The plane is at most kTrailingEdge away and, unless the tool goes through the material, not farther
// than the tool goes into it. Otherwise the tool plunges, and the nose alone cuts. The edge does not cut into a surface
// that the same pass has left, so that the far side of a ball or of a recess has the programmed shape.
// whole: the move that `move` is a piece of. Where the tool ends to go inward decides for all pieces.
std::optional<SectionRemoval> cutMove(TurnedSection& section, const TurningPass& how, const ProfileSegment& move,
                                      const WholeMove& whole, std::uint32_t pass);

// Returns false if the tool of a pass is certainly beside the box of the section during a move. O(1).
bool mayCut(const TurnedSection& section, const TurningPass& how, const ProfileSegment& move);

// Returns true if a nose without a body moves beside the material: around the part with a boring tool, or in a bore
// with an outside tool. Its shank does not reach through the wall, and such a move removes nothing. The simulation of a
// program leaves these moves out of its passes.
bool isBesideMaterial(const TurnedSection& section, const TurningPass& how, const ProfileSegment& move);

inline constexpr double kTrailingEdge = 10.0;  // mm, length of the trailing edge of a tool without a body

// Subtracts a whole pass. Its arcs are exact, and straight runs of points are one move, within 3e-7 mm. The path of an
// unsteady hand is followed within up to 1e-3 mm, so that it is not cut into more than about kManyMoves. Returns
// nothing if a move could not be cut, if the work would take too long, or if it was cancelled. work: the number of
// segments that all moves may visit, from which those that were visited are taken.
inline constexpr std::size_t kManyMoves = 2'000;
inline constexpr std::uint64_t kWorkOfAPass = 2'000'000;  // about a second
std::optional<SectionRemoval> cutPass(TurnedSection& section, const TurningPass& pass, std::uint32_t number,
                                      std::uint64_t& work, Progress progress = {});

// Returns the moves of a pass: its arcs, and lines within `tolerance` (mm) of the other points. The first is the
// position at which the pass begins. O(points).
std::vector<ProfileSegment> movesOf(const TurningPass& pass, double tolerance);

}  // namespace handwheel
