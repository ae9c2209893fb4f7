// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"
#include "machining/section/TurnedSection.h"

namespace handwheel {

// Subtracts the area that the tool of a pass sweeps in one move. The new boundary is marked with the number of the
// pass. Returns nothing if the section could not be cut (TurnedSection::subtract()). Passes of threads and of control
// points (TurningMethod::Poles) remove nothing here.
//
// A lathe tool removes its own area. A nose without a body removes also what lies outward of it or, in a bore, between
// it and the axis, because its shank comes from there. If it has edges (TurningPass::edges) and moves inward more
// steeply than 45°, it removes what its trailing edge sweeps as well, as in facing: all as far as the next plane
// without material. The plane is at most kTrailingEdge away and, unless the tool goes through the material, not farther
// than the tool goes into it. Otherwise the tool plunges, and the nose alone cuts. The edge does not cut into a surface
// that the same pass has left, so that the far side of a ball or of a recess has the programmed shape. whole: the move
// that `move` is a piece of, or the straight run of moves. Its end decides for all pieces.
std::optional<SectionRemoval> cutMove(TurnedSection& section, const TurningPass& how, const ProfileSegment& move,
                                      const ProfileSegment& whole, std::uint32_t pass);

// Returns false if the tool of a pass is certainly beside the box of the section during a move. O(1).
bool mayCut(const TurnedSection& section, const TurningPass& how, const ProfileSegment& move);

inline constexpr double kTrailingEdge = 10.0;  // mm, length of the trailing edge of a tool without a body

// Subtracts a whole pass. Its arcs are exact, and straight runs of points are one move, within 3e-7 mm. The path of an
// unsteady hand is followed within up to 1e-3 mm, so that it is not cut into more than kManyMoves. Returns nothing if a
// move could not be cut, if the work would take too long, or if it was cancelled.
inline constexpr std::size_t kManyMoves = 2'000;
std::optional<SectionRemoval> cutPass(TurnedSection& section, const TurningPass& pass, std::uint32_t number,
                                      Progress progress = {});

// Returns true if a move continues another one, straight on.
bool isStraightOn(const ProfilePoint& along, const ProfilePoint& by);
// Returns the straight run of points of a pass to which the move to point i belongs, if that may face; otherwise, or on
// an arc, the move.
ProfileSegment straightRun(const TurningPass& pass, std::size_t i);

// Returns the moves of a pass: its arcs, and lines within `tolerance` (mm) of the other points. The first is the
// position at which the pass begins. O(points).
std::vector<ProfileSegment> movesOf(const TurningPass& pass, double tolerance);

}  // namespace handwheel
