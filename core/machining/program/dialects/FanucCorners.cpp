// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/dialects/FanucRun.h"

#include <cmath>

namespace handwheel {

// The chamfer ,C or rounding ,R at the end of a cut. At the end of a straight cut along one axis C, I (along Z) or K
// (along X) is a chamfer and R a rounding, too; their sign is the direction of the next cut along the other axis.
std::optional<FanucRun::Corner> FanucRun::cornerOf(int motion) {
  const ProgramWord* found = nullptr;
  Corner corner;
  const auto take = [&](char letter, bool isRound, int axis) {
    const ProgramWord* const w = word(letter);
    if (!w) return;
    if (found) refuse(w->location, w->text(), "it contradicts " + found->text(), "Remove one of them.");
    found = w;
    corner = {w, {isRound, std::abs(m_machine.unit() * w->number)}, axis};
  };
  take('c', false, kAnyAxis);
  take('r', true, kAnyAxis);
  const bool isAcross = has('X') || has('U'), isAlong = has('Z') || has('W');
  if (motion == 1 && isAcross != isAlong) {
    const int axis = isAlong ? 0 : 1;  // axis of the next cut
    take('R', true, axis);
    take('C', false, axis);
    take(isAlong ? 'I' : 'K', false, axis);
  }
  if (!found || found->number == 0.0) return {};
  if (corner.axis == kAnyAxis && found->number < 0.0)
    refuse(found->location, found->text(), "the size of a corner is not negative", "Remove the sign.");
  return corner;
}

// Shortens two moves to the corner between them, and returns the piece there.
ContourSegment FanucRun::pieceOf(const Corner& corner, ContourSegment& before, ContourSegment& after) const {
  const ProgramWord& w = *corner.word;
  if (corner.axis != kAnyAxis) {
    const PlanePoint to = after.to - after.from;
    const double along = corner.axis == 0 ? to.imag() : to.real(), across = corner.axis == 0 ? to.real() : to.imag();
    if (after.turn != 0 || across != 0.0 || along * w.number < 0.0)
      refuse(w.location, w.text(), "the next cut does not go in this direction, straight along the other axis",
             "Correct its sign, or write ,C or ,R.");
  }
  const std::optional<ContourSegment> piece = cornerPiece(before, after, corner.size);
  if (!piece)
    refuse(w.location, w.text(), "the two cuts form no corner, or are too short for this one", "Use a smaller one.");
  return *piece;
}

// Returns the move that follows the block that is being executed. The block itself ends at `corner`, mm.
ContourSegment FanucRun::moveAfter(const PlanePoint& corner, const ProgramWord& w) {
  constexpr int kMostCornerBlocks = 20;
  const ProgramVariables variables = m_variables;
  const ProgramMachine::Modal modal = m_machine.modal;
  const Control control = m_control;
  const auto codes = m_codes;
  const std::size_t notes = m_path.notes.size();
  std::vector<ContourSegment> next;
  m_contour = &next;
  m_contourEnd = corner / m_machine.unit();
  m_cornerWord = &w;
  runAhead(kMostCornerBlocks, [&] { return !next.empty(); });
  m_contour = nullptr;
  m_cornerWord = nullptr;
  m_corners.clear();
  const bool isCut = !next.empty() && m_machine.modal.motion > 0;
  m_variables = variables;
  m_machine.modal = modal;
  m_control = control;
  m_codes = codes;
  m_path.notes.resize(notes);
  if (!isCut) refuseLonely(w);
  ContourSegment& move = next.front();
  for (PlanePoint* const p : {&move.from, &move.to, &move.centre}) *p *= m_machine.unit();
  return move;
}

void FanucRun::refuseLonely(const ProgramWord& w) {
  refuse(w.location, w.text(), "no cut follows that ends the corner", "Write a G1, G2 or G3 in the next line.");
}

// Returns true if corners have taken a whole cut. What rounding leaves of it has no direction.
bool FanucRun::isUsedUp(const ContourSegment& segment) {
  constexpr double kNothing = 1e-7;  // mm or inch
  return std::abs(segment.to - segment.from) < kNothing;
}

// A straight cut or an arc, and the corner at its end.
void FanucRun::cut(int motion, const SourceLocation& location) {
  const std::optional<Corner> corner = cornerOf(motion);
  const PlanePoint tool = planePoint(m_machine.at());
  ContourSegment move;
  move.from = planePoint(m_corner.value_or(m_machine.at()));
  move.to = planePoint(target());
  move.turn = motion == 1 ? 0 : motion == 3 ? 1 : -1;
  if (move.turn != 0) move.centre = arcCentre(move.from, move.to, move.turn, false, location);
  const auto make = [&](const ContourSegment& segment) {
    const ProfilePoint to = profilePoint(segment.to);
    segment.turn == 0 ? m_machine.feed(to, location)
                      : m_machine.arc(segment.turn, to, profilePoint(segment.centre), location);
  };
  const PlanePoint end = move.to;
  if (corner && end == move.from)
    refuse(corner->word->location, corner->word->text(), "the cut before the corner has no length", "Remove it.");
  if (m_corner) move.from = tool;  // the corner has taken a part of the cut
  const bool isAfterCorner = m_corner.has_value();
  m_corner.reset();
  if (!corner) {
    if (!isAfterCorner || !isUsedUp(move)) make(move);
    return;
  }
  ContourSegment after = moveAfter(end, *corner->word);
  const ContourSegment piece = pieceOf(*corner, move, after);
  if (!isUsedUp(move)) make(move);
  make(piece);
  m_corner = profilePoint(end);  // the next move counts from there
}

// Makes the corners of a contour that was collected.
void FanucRun::finishCorners(std::vector<ContourSegment>& segments) {
  const double unit = m_machine.unit();
  for (auto each = m_corners.rbegin(); each != m_corners.rend(); ++each) {
    auto& [index, corner, w] = *each;
    corner.word = &w;
    corner.size.size /= unit;
    if (index + 1 >= segments.size()) refuseLonely(w);
    const ContourSegment piece = pieceOf(corner, segments[index], segments[index + 1]);
    segments.insert(segments.begin() + static_cast<std::ptrdiff_t>(index + 1), piece);
  }
  if (!m_corners.empty()) std::erase_if(segments, isUsedUp);
  m_corners.clear();
}

}  // namespace handwheel
