// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramSimulation.h"

#include "machining/section/SectionSource.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kTouch = 1e-3;       // mm; a rapid that takes less only touches
constexpr double kOnAxis = 1e-6;      // mm
constexpr double kPiece = 1.0;        // mm; piece of a straight move, for its forces
constexpr double kPieceAngle = 0.1;   // rad; piece of an arc
constexpr int kMostPieces = 16;       // limit for a straight move
constexpr int kMostArcPieces = 4096;  // limit for an arc
constexpr std::size_t kPassPoints = 100'000;
constexpr std::size_t kMostUncut = 10'000;  // pieces through air within a pass
constexpr std::size_t kMostRemarks = 100;

int cutsOf(const ToolMove& move) {
  const double longest = lengthOf(move) / kPiece, widest = std::abs(sweepOf(move)) / kPieceAngle;
  return std::clamp(static_cast<int>(std::ceil(std::max(longest, widest))), 1,
                    move.turn == 0 ? kMostPieces : kMostArcPieces);
}

// Returns the path of a move, shifted. The radii at both ends of a programmed arc differ by their rounding; the path is
// one arc all the same. A segment counts its angle from r towards z.
ProfileSegment pathOf(const ToolMove& move, const ProfilePoint& shift) {
  return {move.from + shift, move.to + shift, -std::tan(0.25 * sweepOf(move))};
}

// Returns one of some equal pieces of the path of a move.
ProfileSegment pieceOf(const ProfileSegment& path, const ToolMove& move, int piece, int pieces) {
  const double from = static_cast<double>(piece) / pieces, to = static_cast<double>(piece + 1) / pieces;
  constexpr double kMostAngle = 1.9 * M_PI;  // the ends of a full circle do not define it
  if (std::abs(sweepOf(move)) < kMostAngle) return path.piece(from, to);
  const ProfilePoint shift = path.from - move.from;
  return {pointOn(move, from) + shift, pointOn(move, to) + shift, -std::tan(0.25 * sweepOf(move) / pieces)};
}

// Returns the number of chords of a piece of an arc that are within ProgramSimulation::kChord of it.
int chordsOf(const ProfileSegment& piece) {
  const double radius = piece.radius();
  if (!std::isfinite(radius)) return 1;
  const double step = 2.0 * std::acos(std::max(0.0, 1.0 - ProgramSimulation::kChord / radius));
  return std::clamp(static_cast<int>(std::ceil(std::abs(piece.angle()) / std::max(step, 1e-6))), 1, kMostArcPieces);
}

// Returns the mean thickness of what was removed, mm. What rounding leaves along a wall is long, and as good as
// nothing.
double thicknessOf(const SectionRemoval& removal) {
  return removal.isEmpty() ? 0.0 : removal.area / removal.box.diagonal().norm();
}

}  // namespace

ToolMove mirrored(const ToolMove& move) {
  ToolMove image = move;
  for (ProfilePoint* p : {&image.from, &image.to, &image.centre}) p->x() = -p->x();
  image.turn = static_cast<std::int8_t>(-image.turn);
  return image;
}

ProgramSimulation::ProgramSimulation(TurnedProfile part, const ToolPath& path, const ProgramSetup& setup,
                                     const ProgramState& before, std::size_t done)
    : m_part(std::move(part)),
      m_path(path),
      m_setup(setup),
      m_largest(0.0),
      m_next(done),
      m_state(before),
      m_passesBefore(before.passes),
      m_obstacles(setup, m_part) {
  for (std::size_t i = 0; i < m_part.size(); ++i) m_largest = std::max(m_largest, m_part.radius(i));
}

ProgramState ProgramSimulation::state() const {
  ProgramState state = m_state;
  state.passes = m_passesBefore + m_passes.size() - (m_isPassOpen ? 1 : 0);
  return state;
}

// A tool with a known body cuts by its body. Any other tool is its nose with two edges; a drill is as round as its
// nose.
TurningPass ProgramSimulation::shapeOf(const ToolMove& move) const {
  const ProgramTool& tool = m_setup.toolOf(move);
  TurningPass shape;
  shape.isOfProgram = true;
  shape.isExact = true;
  shape.noseRadius = tool.noseRadius;
  const ProfilePoint tip = tipOf(move);
  if (m_state.isDrilling || tip.x() > 0.0) shape.side = TurningSide::Bore;
  if (tool.body) {
    shape.tool = tool.body;
    shape.side = tool.body->side;
  } else if (!m_state.isDrilling) {
    shape.edges = tip.isZero() ? ProfilePoint(-1, -1) : tip;
  }
  return shape;
}

// Returns the move that comes n moves after this one, if it is of the same tool.
const ToolMove* ProgramSimulation::moveAfter(const ToolMove& move, std::size_t n) const {
  const std::size_t i = m_next - 1 + n;
  return i < m_path.moves.size() && m_path.moves[i].tool == move.tool ? &m_path.moves[i] : nullptr;
}

// A tool may go over the axis by its nose, to take the middle of a face away; it stays on its side. Moves without a
// rapid move among them are on one side: a tool that begins to face beyond the axis is not beyond it.
void ProgramSimulation::followSide(const ToolMove& move) {
  const bool was = m_state.isBeyond && m_state.drill == move.tool;
  if (m_next <= m_sideMoves) return;
  const ProfilePoint none(0.0, 0.0);
  ProfileBox box = pathOf(move, none).box();
  std::size_t count = 1;
  for (const ToolMove* next = moveAfter(move, 1); move.kind != ToolMove::Kind::Rapid && next;) {
    if (next->kind == ToolMove::Kind::Rapid) break;
    if (next->kind != ToolMove::Kind::Dwell) box.extend(pathOf(*next, none).box());
    next = moveAfter(move, ++count);
  }
  m_sideMoves = m_next - 1 + count;
  const double least = box.min().x(), most = box.max().x(), nose = m_setup.toolOf(move).noseRadius;
  m_state.isBeyond = std::max(-least, most) <= nose + kOnAxis ? was : -least > most;
}

// A tool that feeds along the axis towards the chuck is a drill until it leaves the axis, so that it also returns
// through the hole as a drill. A tool that has faced to the axis is none, and one that leaves the axis by a feed, at
// the bottom, begins to face outward there.
void ProgramSimulation::followDrill(const ToolMove& move) {
  const auto isOnAxis = [](const ToolMove& each) {
    return each.kind == ToolMove::Kind::Dwell ||
           (each.turn == 0 && std::abs(each.from.x()) <= kOnAxis && std::abs(each.to.x()) <= kOnAxis);
  };
  const auto& body = m_setup.toolOf(move).body;
  const bool mayDrill = !body || body->kind == LatheToolKind::Drill;
  const bool goesOn = m_state.isDrilling && m_state.drill == move.tool;
  const bool begins = !goesOn && move.kind != ToolMove::Kind::Rapid && move.to.y() < move.from.y();
  m_state.drill = move.tool;
  m_state.isDrilling = mayDrill && isOnAxis(move) && (goesOn || begins);
  if (!m_state.isDrilling || goesOn) return;
  if (m_next > m_axisMoves) {
    std::size_t count = 1;
    const ToolMove* next = moveAfter(move, count);
    while (next && isOnAxis(*next)) next = moveAfter(move, ++count);
    m_axisMoves = m_next - 1 + count;
    m_isFacingFromAxis = next && next->kind == ToolMove::Kind::Feed && next->from.y() < move.from.y();
  }
  m_state.isDrilling = !m_isFacingFromAxis;
}

// Returns the depth of a piece of a move in the material, mm, on the radius: for a point, which removes nothing if it
// moves straight in, from the profile between the samples; for a nose, from the samples.
double ProgramSimulation::deepestOf(const ProfilePoint& a, const ProfilePoint& b, const TurningPass& shape) const {
  return shape.noseRadius > 0.0 ? 0.0 : pointDepth(m_part, a, b);
}

void ProgramSimulation::judge(const ToolMove& move, const Taken& taken, double nose) {
  if (!(taken.deepest > kTouch)) return;
  if (move.kind == ToolMove::Kind::Rapid)
    collide(ProgramCollision::Kind::RapidInMaterial, move, taken.position);
  else if (move.spin == 0 || !(move.spindle > 0.0))
    collide(ProgramCollision::Kind::SpindleAtRest, move, taken.position);
  else
    judgeSpin(move);
  if (m_state.isDrilling && nose == 0.0 && m_notes.size() < kMostRemarks)
    m_notes.push_back({move.line,
                       "The drill leaves no hole: the tool has no diameter. Give it a nose radius of half the "
                       "diameter of the drill."});
}

// A drill cuts clockwise on every machine.
void ProgramSimulation::judgeSpin(const ToolMove& move) {
  if (move.kind != ToolMove::Kind::Feed) return;
  const ProgramPost& post = m_setup.post;
  const bool isOther = m_setup.toolOf(move).isTurnedOver != m_state.isBeyond;
  const int needed = m_state.isDrilling ? 1 : isOther ? -post.cuttingSpin() : post.cuttingSpin();
  if (move.spin == needed || m_notes.size() >= kMostRemarks || !m_wrongSpins.insert(move.tool).second) return;
  const std::string right = needed > 0 ? "M3" : "M4", wrong = needed > 0 ? "M4" : "M3";
  std::string why = "a drill";
  if (!m_state.isDrilling) {
    const bool isInFront = post.isInFront != m_state.isBeyond,
               isUp = post.isInsertUp != m_setup.toolOf(move).isTurnedOver;
    why = std::string("a tool ") + (isInFront ? "in front of" : "behind") + " the axis with its insert facing " +
          (isUp ? "up" : "down");
  }
  m_notes.push_back({move.line, "The spindle turns away from the cutting edge: " + why + " cuts with " + right +
                                    ". Write " + right + " for " + wrong + ", or set up the machine as it is."});
}

ProfilePoint ProgramSimulation::tipOf(const ToolMove& move) const {
  ProfilePoint tip = tipDirection(m_setup.dialect, m_setup.toolOf(move).orientation);
  // A tool that seems to reach through the axis stands on the other side, unless it is in a bore.
  if (m_state.isBeyond) tip.x() = m_part.isBored() ? -tip.x() : -std::abs(tip.x());
  return tip;
}

// Returns the vector from the point that the program controls to the centre of the nose.
ProfilePoint ProgramSimulation::toCentre(const ToolMove& move, double nose) const {
  ProfilePoint toNose = -nose * tipOf(move);
  if (m_state.isDrilling) toNose.x() = 0.0;  // a drill turns about its own axis
  return toNose;
}

// The jaws are around the part: a tool that drills or bores may pass their face, within the part. low: lowest point of
// the nose.
bool ProgramSimulation::isInChuck(const ProfilePoint& low, TurningSide side) const {
  const double held = side == TurningSide::Bore ? 0.0 : m_setup.grip;
  const double face = held - zeroHeight() - kTouch;
  const double reach = m_largest + std::max(m_largest, 40.0);  // mm: jaws and body
  return low.y() < face && low.x() < reach;
}

// A collision is counted on entry only; the tool comes out again.
void ProgramSimulation::meetChuck(const ToolMove& move, double nose, TurningSide side, const ProfilePoint& position) {
  const ProfilePoint toLow = toCentre(move, nose) - ProfilePoint(nose, nose);
  if (isInChuck(move.from.cwiseMin(move.to) + toLow, side) && !m_isInChuck)
    collide(ProgramCollision::Kind::Chuck, move, position);
  m_isInChuck = isInChuck(move.to + toLow, side);
}

// Returns true if it is new and stored.
bool ProgramSimulation::collide(ProgramCollision::Kind kind, const ToolMove& move, const ProfilePoint& position) {
  if (m_collisionCount > 0 && m_lastCollision == move.line) return false;  // only one per line
  m_lastCollision = move.line;
  if (++m_collisionCount > kMostCollisions) return false;
  m_collisions.push_back({kind, move.line, m_state.isBeyond ? mirrored(move).to : move.to, position, m_time});
  m_collisions.back().passes = m_passes.size();
  return true;
}

ProgramSimulation::Removal ProgramSimulation::cutPiece(const TurningPass& shape, const ProfileSegment& piece,
                                                       const WholeMove& whole, std::uint32_t number) {
  if (const std::optional<ExactStep> step = cutExactly(m_part, shape, piece, whole, number)) {
    m_changed.extend(step->changed);
    if (step->removal.isEmpty()) return {};
    return {step->removal.area, thicknessOf(step->removal)};
  }
  return cutSamples(shape, piece.from, piece.to);
}

ProgramSimulation::Removal ProgramSimulation::cutSamples(const TurningPass& shape, const ProfilePoint& a,
                                                         const ProfilePoint& b) {
  Removal removal;
  const TurnedProfile before = m_part;  // shares its pages
  const TurnedProfile::Range changed = cut(m_part, shape, a, b);
  for (std::size_t i = changed.first; i < changed.last; ++i) {
    const double depth = before.radius(i) - before.inner(i) - (m_part.radius(i) - m_part.inner(i));
    if (!(depth > 0.0)) continue;
    removal.area += depth * m_part.spacing();
    removal.depth = std::max(removal.depth, depth);
  }
  m_changed.extend(changed);
  return removal;
}

// A pass is a run of moves with one tool without a rapid move among them.
bool ProgramSimulation::continuesPass(const TurningPass& shape, const ProfilePoint& a) const {
  if (!m_isPassOpen) return false;
  const TurningPass& last = m_passes.back();
  const ProfilePoint& end = m_uncut.empty() ? last.path.back() : m_uncut.back().move.to;
  return last.noseRadius == shape.noseRadius && last.side == shape.side && last.tool == shape.tool &&
         last.edges == shape.edges && end == a && last.path.size() < kPassPoints;
}

void ProgramSimulation::endPass() {
  m_isPassOpen = false;
  m_uncut.clear();
}

// Pieces without a cut are kept until one with a cut follows in the same pass.
void ProgramSimulation::record(const TurningPass& shape, const RecordedPiece& piece, bool isCut) {
  if (!continuesPass(shape, piece.move.from)) {
    endPass();
    if (!isCut) return;
    m_passes.push_back(shape);
    m_passes.back().path.push_back(piece.move.from);
    m_passes.back().times.push_back(0.0);
    m_passes.back().speeds.push_back(piece.speed);
    m_passBegin = piece.begin;
    m_isPassOpen = true;
  }
  m_uncut.push_back(piece);
  if (!isCut) {
    if (m_uncut.size() > kMostUncut) endPass();
    return;
  }
  for (const RecordedPiece& each : std::exchange(m_uncut, {})) append(each);
}

void ProgramSimulation::append(const RecordedPiece& piece) {
  TurningPass& pass = m_passes.back();
  const auto first = static_cast<std::uint32_t>(pass.path.size() - 1);
  const int chords = chordsOf(piece.move);
  for (int i = 1; i <= chords; ++i) {
    const double share = static_cast<double>(i) / chords, now = piece.begin + share * (piece.end - piece.begin);
    pass.path.push_back(i == chords ? piece.move.to : piece.move.at(share));
    pass.times.push_back(std::max(now - m_passBegin, pass.times.back()));
    pass.speeds.push_back(piece.speed);
  }
  if (!piece.move.isArc()) return;
  const auto last = static_cast<std::uint32_t>(pass.path.size() - 1);
  const bool goesOn = piece.isOfSameArc && !pass.arcs.empty() && pass.arcs.back().last == first;
  const double quarter = std::atan(piece.move.bulge) + (goesOn ? std::atan(pass.arcs.back().bulge) : 0.0);
  constexpr double kMostQuarter = 0.25 * 1.75 * M_PI;  // the ends of a full circle do not define it
  if (goesOn && std::abs(quarter) < kMostQuarter)
    pass.arcs.back() = {pass.arcs.back().first, last, std::tan(quarter)};
  else
    pass.arcs.push_back({first, last, piece.move.bulge});
}

bool ProgramSimulation::step(double share) {
  if (m_next >= m_path.moves.size()) return false;
  const ToolMove& written = m_path.moves[m_next++];
  followSide(written);
  const ToolMove whole = m_state.isBeyond ? mirrored(written) : written;
  ToolMove move = whole;
  if (share < 1.0) move.to = pointOn(whole, share);
  m_time += move.time;
  if (move.kind == ToolMove::Kind::Dwell) return true;
  followDrill(move);
  if (isThread(move)) {
    cutThread(move);
    followBody(move);
    return true;
  }
  const bool isLeaving = leavesThread(move);
  m_state.lead.reset();
  const TurningPass shape = shapeOf(move);
  const Taken taken = isLeaving ? Taken{0.0, move.to + ProfilePoint(0.0, zeroHeight())} : cutMove(move, whole, shape);
  if (isLeaving) followBody(move);
  meetChuck(move, shape.noseRadius, shape.side, taken.position);
  judge(move, taken, shape.noseRadius);
  return true;
}

// A body is checked at the end of each piece, when the material of the nose is already removed.
int ProgramSimulation::piecesOf(const ToolMove& move) const {
  const int cuts = cutsOf(move);
  if (!m_setup.toolOf(move).body) return cuts;
  return std::clamp(static_cast<int>(std::ceil(lengthOf(move) / kPiece)), cuts, kMostArcPieces);
}

// A contact is counted on entry only; the tool comes out again.
void ProgramSimulation::meetBody(const ToolMove& move, const ProfilePoint& centre, double nose) {
  const LatheTool& body = *m_setup.toolOf(move).body;
  const auto contact = m_obstacles.contact(body, bodyTipFrom(body, centre, nose), m_part);
  if (std::exchange(m_isTouching, contact.has_value()) || !contact) return;
  const bool isKept = collide(ProgramCollision::Kind::Contact, move, contact->position);
  if (!isKept) return;
  m_collisions.back().moving = contact->moving;
  m_collisions.back().struck = contact->struck;
}

// Checks the body along a move that removes nothing from the profile.
void ProgramSimulation::followBody(const ToolMove& move) {
  const ProgramTool& tool = m_setup.toolOf(move);
  if (!tool.body) return;
  const ProfilePoint toPart = toCentre(move, tool.noseRadius) + ProfilePoint(0.0, zeroHeight());
  const int pieces = piecesOf(move);
  for (int i = 1; i <= pieces; ++i)
    meetBody(move, pointOn(move, static_cast<double>(i) / pieces) + toPart, tool.noseRadius);
}

// Returns true if a rapid move draws a tool straight back from a shoulder that it has made. The shoulder leans by the
// angle of the edge, and the tool springs along it, as on the manual lathe.
bool ProgramSimulation::isDrawnBack(const ToolMove& move, const TurningPass& shape, const ProfileSegment& path) const {
  if (move.kind != ToolMove::Kind::Rapid || !shape.tool) return false;
  const ProfilePoint by = path.to - path.from;
  const double back = shape.tool->side == TurningSide::Bore ? -by.x() : by.x();
  if (!(back > 0.0) || std::abs(by.y()) > back) return false;
  constexpr double kDrawnSpring = 1.0;  // mm; 11 mm deep, an edge of 95° leans by 0.96
  for (const double along : {kDrawnSpring, -kDrawnSpring}) {
    const ProfilePoint beside(0.0, along);
    const ProfileSegment sprung{path.from + beside, path.to + beside, path.bulge};
    TurnedProfile part = m_part;
    const auto step = cutExactly(part, shape, sprung, sprung, 0);
    if (step && !(thicknessOf(step->removal) > kTouch)) return true;
  }
  return false;
}

// Returns WholeMove::end of the last move, in the program: as seen on the side of the axis where the tool is.
ProfilePoint ProgramSimulation::inwardEndOf(const ToolMove& whole, const TurningPass& shape) {
  const ProfilePoint none(0.0, 0.0);
  const auto image = [&](const ToolMove& move) { return pathOf(m_state.isBeyond ? mirrored(move) : move, none); };
  if (whole.kind != ToolMove::Kind::Feed || !goesInward(shape, pathOf(whole, none).direction(1.0))) return whole.to;
  if (m_next <= m_inwardMoves) return m_inwardEnd;
  m_inwardEnd = whole.to;
  for (m_inwardMoves = m_next; m_inwardMoves < m_path.moves.size(); ++m_inwardMoves) {
    const ToolMove& next = m_path.moves[m_inwardMoves];
    if (next.kind == ToolMove::Kind::Dwell || (next.turn == 0 && next.from == next.to)) continue;
    if (next.kind != ToolMove::Kind::Feed || next.tool != whole.tool || isThread(next)) break;
    const ProfileSegment path = image(next);
    const std::optional<ProfilePoint> end = inwardEnd(shape, path);
    m_inwardEnd = end.value_or(m_inwardEnd);
    if (!end || *end != path.to) break;
  }
  return m_inwardEnd;
}

ProgramSimulation::Taken ProgramSimulation::cutMove(const ToolMove& move, const ToolMove& whole,
                                                    const TurningPass& shape) {
  const ProfilePoint toPart = toCentre(move, shape.noseRadius) + ProfilePoint(0.0, zeroHeight());
  // The path of a tool is that of its tip.
  const ProfilePoint toTip =
      shape.tool ? bodyTipFrom(*shape.tool, ProfilePoint(0.0, 0.0), shape.noseRadius) : ProfilePoint(0.0, 0.0);
  const int pieces = piecesOf(move);
  const ProfilePoint shift = toPart + toTip;
  const ProfileSegment path = pathOf(move, shift), written = pathOf(whole, shift);
  const WholeMove run(written, inwardEndOf(whole, shape) + shift);
  const bool isRapid = move.kind == ToolMove::Kind::Rapid;
  if (isRapid || m_wasRapid) endPass();
  m_wasRapid = isRapid;
  if (isDrawnBack(move, shape, path)) {
    followBody(move);
    return {0.0, move.to + toPart};
  }
  double end = m_time - move.time;
  Taken taken;
  std::optional<ProfilePoint> first;
  for (int i = 0; i < pieces; ++i) {
    const MovePiece share{static_cast<double>(i) / pieces, static_cast<double>(i + 1) / pieces};
    const ProfilePoint a = pointOn(move, share.from) + toPart, b = pointOn(move, share.to) + toPart;
    const ProfileSegment piece = pieceOf(path, move, i, pieces);
    const double seconds = timeOf(move, share), spindle = spindleOf(move, share);
    end += seconds;
    taken.deepest = std::max(taken.deepest, deepestOf(a, b, shape));
    const bool isBeside = m_part.section() && isBesideMaterial(m_part.section()->section(), shape, piece);
    if (isBeside) endPass();
    const bool goesOn = continuesPass(shape, piece.from);
    const std::size_t number = m_passesBefore + m_passes.size() - (goesOn ? 1 : 0);
    const Removal removal = isBeside ? Removal() : cutPiece(shape, piece, run, static_cast<std::uint32_t>(number));
    const bool isCut = removal.area > 0.0;
    record(shape, {piece, end - seconds, end, spindle, i > 0}, isCut);
    if (isCut && !first) first = b;
    taken.deepest = std::max(taken.deepest, removal.depth);
    if (shape.tool) meetBody(move, b, shape.noseRadius);
  }
  taken.position = first.value_or(move.to + toPart);
  return taken;
}

bool ProgramSimulation::run(Progress progress) {
  constexpr std::size_t kLook = 64;  // moves between two checks of the cancel flag
  while (step()) {
    if (m_next % kLook != 0) continue;
    if (progress.cancelled()) return false;
    progress.set(static_cast<double>(m_next) / static_cast<double>(m_path.moves.size()));
  }
  return !progress.cancelled();
}

}  // namespace handwheel
