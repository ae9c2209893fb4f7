// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramSimulation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kTouch = 1e-3;       // mm: a rapid that takes less only touches
constexpr double kOnAxis = 1e-6;      // mm
constexpr double kPiece = 1.0;        // mm, of a straight move, for its forces
constexpr int kMostPieces = 16;       // of a straight move
constexpr int kMostArcPieces = 4096;  // of an arc
constexpr std::size_t kPassPoints = 100'000;
constexpr std::size_t kMostRemarks = 100;

int piecesOf(const ToolMove& move) {
  if (move.turn == 0) return std::clamp(static_cast<int>(std::ceil(lengthOf(move) / kPiece)), 1, kMostPieces);
  const double radius = std::max((move.from - move.centre).norm(), 1e-9);
  const double step = 2.0 * std::acos(std::max(0.0, 1.0 - ProgramSimulation::kChord / radius));
  return std::clamp(static_cast<int>(std::ceil(std::abs(sweepOf(move)) / std::max(step, 1e-6))), 1, kMostArcPieces);
}

// A spiral on a face has no groove along the axis, and what is finer than any thread is a feed: both are cut as any
// other move is.
bool isThread(const ToolMove& move) {
  const double along = std::abs(move.to.y() - move.from.y()), length = lengthOf(move);
  if (move.kind != ToolMove::Kind::Thread || !(along > 1e-3 * length)) return false;
  const double pitch = move.feed * along / length;
  return pitch >= ThreadCut::kLeastPitch && pitch <= ThreadCut::kLargestPitch &&
         along / pitch <= ThreadGroove::kMostTurns;
}

// The area between the edge and a line at this height (mm) above the bottom of a groove, by Simpson's rule; mm².
double sectionOf(const ThreadCut& cut, double height, double noseRadius) {
  constexpr int kParts = 32;
  double sum = 0.0;
  for (int i = 0; i <= kParts; ++i) {
    const double width = 2.0 * cut.distanceAt(height * i / kParts, noseRadius);
    sum += width * (i == 0 || i == kParts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
  }
  return sum * height / (3.0 * kParts);
}

}  // namespace

ProgramSimulation::ProgramSimulation(TurnedProfile part, const ToolPath& path, const ProgramSetup& setup,
                                     const CuttingForceModel* model)
    : m_part(std::move(part)), m_path(path), m_setup(setup), m_model(model), m_largest(0.0) {
  for (std::size_t i = 0; i < m_part.size(); ++i) m_largest = std::max(m_largest, m_part.radius(i));
}

TurningPass ProgramSimulation::shapeOf(const ToolMove& move) const {
  const ProgramTool& tool = m_setup.toolOf(move);
  TurningPass shape;
  shape.noseRadius = tool.noseRadius;
  const bool isBoring = tipDirection(m_setup.dialect, tool.orientation).x() > 0.0;
  if (m_isDrilling || isBoring) shape.side = TurningSide::Bore;
  return shape;
}

// A tool that feeds along the axis towards the chuck is a drill until it leaves the axis, so that its way back through
// the hole is one, too; a tool that has faced to the axis is not.
void ProgramSimulation::followDrill(const ToolMove& move) {
  const bool isOnAxis = move.turn == 0 && std::abs(move.from.x()) <= kOnAxis && std::abs(move.to.x()) <= kOnAxis;
  const bool begins = move.kind != ToolMove::Kind::Rapid && move.to.y() < move.from.y();
  m_isDrilling = isOnAxis && (begins || (m_isDrilling && m_drill == move.tool));
  m_drill = move.tool;
}

// How deep a piece of a move is in the material, mm, on the radius: of a point, which takes nothing where it moves
// straight in, from the profile between the samples. Of a nose the samples tell it.
double ProgramSimulation::deepestOf(const ProfilePoint& a, const ProfilePoint& b, const TurningPass& shape) const {
  return shape.noseRadius > 0.0 ? 0.0 : pointDepth(m_part, a, b);
}

void ProgramSimulation::judge(const ToolMove& move, double deepest, double nose) {
  if (!(deepest > kTouch)) return;
  if (move.kind == ToolMove::Kind::Rapid)
    collide(ProgramCollision::Kind::RapidInMaterial, move);
  else if (move.spin == 0 || !(move.spindle > 0.0))
    collide(ProgramCollision::Kind::SpindleAtRest, move);
  else if (move.spin < 0 && move.kind == ToolMove::Kind::Feed)
    collide(ProgramCollision::Kind::SpindleReversed, move);
  if (m_isDrilling && nose == 0.0 && m_notes.size() < kMostRemarks)
    m_notes.push_back({move.line,
                       "The drill leaves no hole: the tool has no diameter. Give it a nose radius of half the "
                       "diameter of the drill."});
}

// From the point that the program controls to the centre of the nose.
ProfilePoint ProgramSimulation::toCentre(const ToolMove& move, double nose) const {
  ProfilePoint way = -nose * tipDirection(m_setup.dialect, m_setup.toolOf(move).orientation);
  if (m_isDrilling) way.x() = 0.0;  // a drill turns about its own axis
  return way;
}

bool ProgramSimulation::reachesChuck(const ToolMove& move, double nose) const {
  const double face = m_setup.grip - m_part.length() - kTouch;
  const ProfilePoint low = move.from.cwiseMin(move.to) + toCentre(move, nose) - ProfilePoint(nose, nose);
  const double reach = m_largest + std::max(m_largest, 40.0);  // mm: jaws and body
  return low.y() < face && low.x() < reach;
}

void ProgramSimulation::collide(ProgramCollision::Kind kind, const ToolMove& move) {
  if (m_collisionCount > 0 && m_lastCollision == move.line) return;  // of one line one
  m_lastCollision = move.line;
  if (++m_collisionCount <= kMostCollisions) m_collisions.push_back({kind, move.line, move.to});
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
                      m_passes.back().side == shape.side && m_passes.back().path.back() == a &&
                      m_passes.back().path.size() < kPassPoints;
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

void ProgramSimulation::meet(const ToolMove& move, const Removal& removal, double seconds, double length) {
  if (!m_model) return;
  SpindleSetting spindle;
  spindle.speed = move.isSurfaceSpeed ? move.mostSpindle : move.spindle;
  spindle.surfaceSpeed = move.isSurfaceSpeed ? move.spindle : 0.0;
  const bool isSame = m_meter && m_spindle.speed == spindle.speed && m_spindle.surfaceSpeed == spindle.surfaceSpeed;
  if (!isSame) {
    m_peaks = peaks();
    m_spindle = spindle;
    m_meter.emplace(*m_model, spindle, m_part.spacing());
  }
  m_meter->add(length, seconds, removal.area, removal.radius);
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
    if (reachesChuck(move, m_setup.toolOf(move).noseRadius)) collide(ProgramCollision::Kind::Chuck, move);
    cutThread(move);
    return true;
  }
  const bool isLeaving = leavesThread(move);
  m_lead.reset();
  if (isLeaving) return true;
  const TurningPass shape = shapeOf(move);
  if (reachesChuck(move, shape.noseRadius)) collide(ProgramCollision::Kind::Chuck, move);
  const ProfilePoint toPart = toCentre(move, shape.noseRadius) + ProfilePoint(0.0, m_part.length());
  const double reach = m_largest + shape.noseRadius;
  const int pieces = piecesOf(move);
  const double length = lengthOf(move) / pieces, seconds = move.time / pieces;
  double deepest = 0.0;
  for (int i = 0; i < pieces; ++i) {
    const ProfilePoint a = pointOn(move, static_cast<double>(i) / pieces) + toPart;
    const ProfilePoint b = pointOn(move, static_cast<double>(i + 1) / pieces) + toPart;
    Removal removal;
    deepest = std::max(deepest, deepestOf(a, b, shape));
    if (std::min(a.x(), b.x()) <= reach && !samplesBelow(a, b, shape.noseRadius).isEmpty())
      removal = cutPiece(shape, a, b);
    if (removal.area > 0.0) {
      const double end = m_time - move.time + seconds * (i + 1);
      record(shape, a, b, end - seconds, end, move.spin == 0 ? 0.0 : spindleAt(move, removal.radius));
    }
    meet(move, removal, seconds, length);
    deepest = std::max(deepest, removal.depth);
  }
  judge(move, deepest, shape.noseRadius);
  return true;
}

// A tool is drawn back out of its groove, between the flanks.
bool ProgramSimulation::leavesThread(const ToolMove& move) const {
  if (!m_lead || move.turn != 0 || m_lead->end != move.from) return false;
  const ProfilePoint way = move.to - move.from;
  return std::abs(way.y()) <= std::abs(way.x()) * std::tan(0.5 * ThreadCut().angle) + kOnAxis;
}

// The work turns against the tool: where the spindle runs forward and the tool goes towards the chuck the thread is
// right-hand. The first move of several begins in the half plane of +x.
TurningPass ProgramSimulation::threadOf(const ToolMove& move) const {
  const ProgramTool& tool = m_setup.toolOf(move);
  const double length = m_part.length(), nose = tool.noseRadius;
  const ProfilePoint shift = ProfilePoint(0.0, length) - nose * tipDirection(m_setup.dialect, tool.orientation);
  const double way = move.to.y() - move.from.y();
  TurningPass pass;
  pass.noseRadius = nose;
  pass.path = {move.from + shift, move.to + shift};
  pass.times = {0.0, move.time};
  const ProfilePoint middle = 0.5 * (pass.path[0] + pass.path[1]);
  pass.speeds.assign(2, move.spin == 0 ? 0.0 : spindleAt(move, middle.x()));
  const double at = std::clamp(middle.y() / m_part.spacing(), 0.0, static_cast<double>(m_part.size() - 1));
  const auto sample = static_cast<std::size_t>(at);
  const double bore = m_part.inner(sample);
  if (bore > 0.0 && middle.x() - bore < m_part.radius(sample) - middle.x()) pass.side = TurningSide::Bore;
  ThreadCut thread;
  thread.pitch = move.feed * std::abs(way) / lengthOf(move);
  const double forward = move.spin < 0 ? -1.0 : 1.0;
  thread.isLeft = way * forward > 0.0;
  const double turned = m_lead ? -forward * m_lead->turns : 0.0;  // of the tool about the work
  const double offset = pass.path[0].y() - thread.rise() * turned;
  thread.offset = offset - thread.pitch * std::floor(offset / thread.pitch);
  pass.thread = thread;
  return pass;
}

// The chip of a thread is what its section has more than that of the pass before: an area for each turn.
void ProgramSimulation::meetThread(const ToolMove& move, const ThreadGroove& groove) {
  const double middle = 0.5 * (std::max(groove.from(), 0.0) + std::min(groove.to(), m_part.length()));
  const double at = std::clamp(middle / m_part.spacing(), 0.0, static_cast<double>(m_part.size() - 1));
  const auto sample = static_cast<std::size_t>(at);
  const bool isBore = groove.side() == TurningSide::Bore;
  const double surface = isBore ? m_part.inner(sample) : m_part.radius(sample);
  const double section = sectionOf(groove.cut(), std::abs(surface - groove.deepest()), groove.noseRadius());
  if (std::abs(m_sectionPitch - groove.cut().pitch) > kOnAxis) m_section = 0.0;
  Removal removal;
  removal.area = std::max(0.0, section - m_section) / groove.cut().lead() * lengthOf(move);
  removal.radius = surface;
  m_section = std::max(m_section, section);
  m_sectionPitch = groove.cut().pitch;
  meet(move, removal, move.time, lengthOf(move));
}

// Of several moves the passes are one where they go on with the same lead.
void ProgramSimulation::cutThread(const ToolMove& move) {
  if (m_lead && m_lead->end != move.from) m_lead.reset();
  TurningPass pass = threadOf(move);
  const std::vector<ThreadGroove> grooves = ThreadGroove::of(pass);
  if (!grooves.empty() && grooves.front().touches(m_part)) {
    meetThread(move, grooves.front());
    const bool goesOn = m_lead && !m_passes.empty() && m_passes.back().thread && m_passes.back().side == pass.side &&
                        m_passes.back().path.back() == pass.path.front() &&
                        std::abs(m_passes.back().thread->pitch - pass.thread->pitch) < kOnAxis &&
                        m_passes.back().thread->isLeft == pass.thread->isLeft;
    if (goesOn) {
      m_passes.back().path.push_back(pass.path.back());
      m_passes.back().times.push_back(std::max(m_time - m_passBegin, m_passes.back().times.back()));
      m_passes.back().speeds.push_back(pass.speeds.back());
    } else {
      m_passBegin = m_time - move.time;
      m_passes.push_back(std::move(pass));
    }
  }
  const double turns = m_lead ? m_lead->turns : 0.0;
  m_lead = Lead{move.to, turns + lengthOf(move) / move.feed};
}

TurnedProfile::Range ProgramSimulation::samplesBelow(const ProfilePoint& a, const ProfilePoint& b, double nose) const {
  return m_part.samplesUnder(a, b, std::max(nose, m_part.spacing()));
}

bool ProgramSimulation::run(Progress progress) {
  constexpr std::size_t kLook = 64;  // moves between two looks at the cancel flag
  while (step()) {
    if (m_next % kLook != 0) continue;
    if (progress.cancelled()) return false;
    progress.set(static_cast<double>(m_next) / static_cast<double>(m_path.moves.size()));
  }
  return !progress.cancelled();
}

}  // namespace handwheel
