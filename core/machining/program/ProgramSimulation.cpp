// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramSimulation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kTouch = 1e-3;       // mm; a rapid that takes less only touches
constexpr double kOnAxis = 1e-6;      // mm
constexpr double kPiece = 1.0;        // mm; piece of a straight move, for its forces
constexpr int kMostPieces = 16;       // limit for a straight move
constexpr int kMostArcPieces = 4096;  // limit for an arc
constexpr std::size_t kPassPoints = 100'000;
constexpr std::size_t kMostRemarks = 100;

int cutsOf(const ToolMove& move) {
  if (move.turn == 0) return std::clamp(static_cast<int>(std::ceil(lengthOf(move) / kPiece)), 1, kMostPieces);
  const double radius = std::max((move.from - move.centre).norm(), 1e-9);
  const double step = 2.0 * std::acos(std::max(0.0, 1.0 - ProgramSimulation::kChord / radius));
  return std::clamp(static_cast<int>(std::ceil(std::abs(sweepOf(move)) / std::max(step, 1e-6))), 1, kMostArcPieces);
}

}  // namespace

ProgramSimulation::ProgramSimulation(TurnedProfile part, const ToolPath& path, const ProgramSetup& setup,
                                     const CuttingForceModel* model, const ProgramState& before)
    : m_part(std::move(part)),
      m_path(path),
      m_setup(setup),
      m_model(model),
      m_largest(0.0),
      m_state(before),
      m_obstacles(setup, m_part) {
  for (std::size_t i = 0; i < m_part.size(); ++i) m_largest = std::max(m_largest, m_part.radius(i));
}

TurningPass ProgramSimulation::shapeOf(const ToolMove& move) const {
  const ProgramTool& tool = m_setup.toolOf(move);
  TurningPass shape;
  shape.isOfProgram = true;
  shape.noseRadius = tool.noseRadius;
  const bool isBoring = tipDirection(m_setup.dialect, tool.orientation).x() > 0.0;
  if (m_state.isDrilling || isBoring) shape.side = TurningSide::Bore;
  // A drill with a known body has its point; any other drill is as round as its nose.
  if (m_state.isDrilling && tool.body && tool.body->kind == LatheToolKind::Drill) shape.tool = tool.body;
  return shape;
}

// A tool that feeds along the axis towards the chuck is a drill until it leaves the axis, so that it also returns
// through the hole as a drill; a tool that has faced to the axis is not.
void ProgramSimulation::followDrill(const ToolMove& move) {
  const bool isOnAxis = move.turn == 0 && std::abs(move.from.x()) <= kOnAxis && std::abs(move.to.x()) <= kOnAxis;
  const bool begins = move.kind != ToolMove::Kind::Rapid && move.to.y() < move.from.y();
  m_state.isDrilling = isOnAxis && (begins || (m_state.isDrilling && m_state.drill == move.tool));
  m_state.drill = move.tool;
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
  else if (move.spin < 0 && move.kind == ToolMove::Kind::Feed)
    collide(ProgramCollision::Kind::SpindleReversed, move, taken.position);
  if (m_state.isDrilling && nose == 0.0 && m_notes.size() < kMostRemarks)
    m_notes.push_back({move.line,
                       "The drill leaves no hole: the tool has no diameter. Give it a nose radius of half the "
                       "diameter of the drill."});
}

// Returns the vector from the point that the program controls to the centre of the nose.
ProfilePoint ProgramSimulation::toCentre(const ToolMove& move, double nose) const {
  ProfilePoint toNose = -nose * tipDirection(m_setup.dialect, m_setup.toolOf(move).orientation);
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
  m_collisions.push_back({kind, move.line, move.to, position, m_time});
  m_collisions.back().passes = m_passes.size();
  return true;
}

ProgramSimulation::Removal ProgramSimulation::cutPiece(const TurningPass& shape, const ProfilePoint& a,
                                                       const ProfilePoint& b) {
  Removal removal;
  const TurnedProfile before = m_part;  // shares its pages
  const TurnedProfile::Range changed = cut(m_part, shape, a, b);
  for (std::size_t i = changed.first; i < changed.last; ++i) {
    const double depth = before.radius(i) - before.inner(i) - (m_part.radius(i) - m_part.inner(i));
    if (!(depth > 0.0)) continue;
    removal.area += depth * m_part.spacing();
    removal.depth = std::max(removal.depth, depth);
    removal.radius = std::max(removal.radius, shape.side == TurningSide::Bore ? m_part.inner(i) : before.radius(i));
  }
  m_changed.extend(changed);
  return removal;
}

void ProgramSimulation::record(const TurningPass& shape, const ProfilePoint& a, const ProfilePoint& b, double begin,
                               double end, double speed) {
  const bool goesOn = !m_passes.empty() && !m_passes.back().thread && m_passes.back().noseRadius == shape.noseRadius &&
                      m_passes.back().side == shape.side && m_passes.back().tool == shape.tool &&
                      m_passes.back().path.back() == a && m_passes.back().path.size() < kPassPoints;
  if (!goesOn) {
    m_passes.push_back(shape);
    m_passes.back().path.push_back(a);
    m_passes.back().times.push_back(0.0);
    m_passes.back().speeds.push_back(speed);
    m_passBegin = begin;
  }
  m_passes.back().path.push_back(b);
  m_passes.back().times.push_back(std::max(end - m_passBegin, m_passes.back().times.back()));
  m_passes.back().speeds.push_back(speed);
}

// Returns the meter for the spindle setting of the move. There must be a model.
ForcePeakMeter& ProgramSimulation::meterOf(const ToolMove& move) {
  SpindleSetting spindle;
  spindle.speed = move.isSurfaceSpeed ? move.mostSpindle : move.spindle;
  spindle.surfaceSpeed = move.isSurfaceSpeed ? move.spindle : 0.0;
  const bool isSame = m_meter && m_spindle.speed == spindle.speed && m_spindle.surfaceSpeed == spindle.surfaceSpeed;
  if (!isSame) {
    m_peaks = peaks();
    m_spindle = spindle;
    m_meter.emplace(*m_model, spindle, m_part.spacing());
  }
  return *m_meter;
}

ForcePeaks ProgramSimulation::peaks() {
  if (!m_meter) return m_peaks;
  const ForcePeaks more = m_meter->finish();
  ForcePeaks all = more.force > m_peaks.force ? more : m_peaks;
  all.power = std::max(more.power, m_peaks.power);
  all.torque = std::max(more.torque, m_peaks.torque);
  all.isOutsideModel = more.isOutsideModel || m_peaks.isOutsideModel;
  m_peaks = all;
  m_meter.reset();
  return all;
}

bool ProgramSimulation::step() {
  if (m_next >= m_path.moves.size()) return false;
  const ToolMove& move = m_path.moves[m_next++];
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
  const Taken taken = isLeaving ? Taken{0.0, move.to + ProfilePoint(0.0, zeroHeight())} : cutMove(move, shape);
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

ProgramSimulation::Taken ProgramSimulation::cutMove(const ToolMove& move, const TurningPass& shape) {
  const ProfilePoint toPart = toCentre(move, shape.noseRadius) + ProfilePoint(0.0, zeroHeight());
  // The path of a tool is that of its tip.
  const ProfilePoint toTip(0.0, shape.tool ? -shape.noseRadius : 0.0);
  const double reach = m_largest + shape.noseRadius;
  const int pieces = piecesOf(move);
  const bool hasBody = m_setup.toolOf(move).body != nullptr;
  const double length = lengthOf(move) / pieces, seconds = move.time / pieces;
  Taken taken;
  std::optional<ProfilePoint> first;
  for (int i = 0; i < pieces; ++i) {
    const ProfilePoint a = pointOn(move, static_cast<double>(i) / pieces) + toPart;
    const ProfilePoint b = pointOn(move, static_cast<double>(i + 1) / pieces) + toPart;
    Removal removal;
    taken.deepest = std::max(taken.deepest, deepestOf(a, b, shape));
    if (std::min(a.x(), b.x()) <= reach && !samplesBelow(a, b, shape.noseRadius).isEmpty())
      removal = cutPiece(shape, a + toTip, b + toTip);
    if (removal.area > 0.0) {
      const double end = m_time - move.time + seconds * (i + 1);
      record(shape, a + toTip, b + toTip, end - seconds, end, move.spin == 0 ? 0.0 : spindleAt(move, removal.radius));
      if (!first) first = b;
    }
    if (m_model) meterOf(move).add(length, seconds, removal.area, removal.radius);
    taken.deepest = std::max(taken.deepest, removal.depth);
    if (hasBody) meetBody(move, b, shape.noseRadius);
  }
  taken.position = first.value_or(move.to + toPart);
  return taken;
}

TurnedProfile::Range ProgramSimulation::samplesBelow(const ProfilePoint& a, const ProfilePoint& b, double nose) const {
  return m_part.samplesUnder(a, b, std::max(nose, m_part.spacing()));
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
