// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ToolPath.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Returns the angle from the centre, in the plane of z and r.
double angleOf(const ProfilePoint& centre, const ProfilePoint& p) {
  return std::atan2(p.x() - centre.x(), p.y() - centre.y());
}

}  // namespace

double sweepOf(const ToolMove& move) {
  if (move.turn == 0) return 0.0;
  double sweep = angleOf(move.centre, move.to) - angleOf(move.centre, move.from);
  constexpr double kSame = 1e-9;  // radian; the same position, so a whole turn
  if (move.turn > 0 && sweep <= kSame) sweep += 2.0 * M_PI;
  if (move.turn < 0 && sweep >= -kSame) sweep -= 2.0 * M_PI;
  return sweep;
}

double lengthOf(const ToolMove& move) {
  if (move.kind == ToolMove::Kind::Dwell) return 0.0;
  if (move.turn == 0) return (move.to - move.from).norm();
  return std::abs(sweepOf(move)) * (move.from - move.centre).norm();
}

ProfilePoint pointOn(const ToolMove& move, double fraction) {
  if (fraction >= 1.0) return move.to;
  if (fraction <= 0.0) return move.from;
  if (move.turn == 0) return move.from + fraction * (move.to - move.from);
  const double angle = angleOf(move.centre, move.from) + fraction * sweepOf(move);
  const double begin = (move.from - move.centre).norm(), end = (move.to - move.centre).norm();
  return move.centre + (begin + fraction * (end - begin)) * ProfilePoint(std::sin(angle), std::cos(angle));
}

ProfilePoint directionOf(const ToolMove& move, double fraction) {
  if (move.turn == 0) {
    const ProfilePoint along = move.to - move.from;
    return along.norm() > 0.0 ? ProfilePoint(along.normalized()) : ProfilePoint(0, 0);
  }
  const ProfilePoint out = pointOn(move, fraction) - move.centre;
  const ProfilePoint left(out.y(), -out.x());  // counter-clockwise from out: z to r
  return out.norm() > 0.0 ? ProfilePoint(static_cast<double>(move.turn) * left.normalized()) : ProfilePoint(0, 0);
}

double spindleAt(const ToolMove& move, double radius) {
  if (!move.isSurfaceSpeed) return move.spindle;
  const double most = move.mostSpindle > 0.0 ? std::min(move.mostSpindle, kMostSpindle) : kMostSpindle;
  const double around = 2.0 * M_PI * std::abs(radius);
  return around > 0.0 ? std::min(most, 1000.0 * move.spindle / around) : most;
}

double durationOf(const ToolMove& move, double rapidSpeed) {
  const double length = lengthOf(move);
  if (move.kind == ToolMove::Kind::Dwell) return move.time;
  if (move.kind == ToolMove::Kind::Rapid) return length / rapidSpeed * 60.0;
  if (!(move.feed > 0.0)) return 0.0;
  const bool turns = move.isPerRevolution || move.kind == ToolMove::Kind::Thread;
  if (!turns) return length / move.feed * 60.0;
  const int parts = move.isSurfaceSpeed ? 16 : 1;  // the speed depends on the radius: midpoint rule
  double revolutions = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double spindle = std::max(1.0, spindleAt(move, pointOn(move, (i + 0.5) / parts).x()));
    revolutions += length / parts / (move.feed * spindle);
  }
  return revolutions * 60.0;
}

}  // namespace handwheel
