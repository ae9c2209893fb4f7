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

bool isPerRevolution(const ToolMove& move) {
  return move.isPerRevolution || move.kind == ToolMove::Kind::Thread;
}

// Returns true if the speed of the tool changes along the move.
bool hasVaryingSpeed(const ToolMove& move) {
  return move.isSurfaceSpeed && isPerRevolution(move) && move.kind != ToolMove::Kind::Rapid &&
         move.kind != ToolMove::Kind::Dwell;
}

// Returns the time of a revolution at a radius, min.
double revolutionAt(const ToolMove& move, double radius) {
  return 1.0 / std::max(1.0, spindleAt(move, radius));
}

// Returns the mean time of a revolution on a straight piece from one radius to another: the time grows with the radius
// beyond the one at which the limit of the spindle ends.
double meanRevolution(const ToolMove& move, double from, double to) {
  const double shortest = revolutionAt(move, 0.0), perRadius = 2.0 * M_PI / (1000.0 * move.spindle);
  if (!(std::abs(to - from) > 1e-9) || !std::isfinite(perRadius)) return revolutionAt(move, 0.5 * (from + to));
  const auto integral = [&](double radius) {
    const double r = std::abs(radius), limited = shortest / perRadius;
    const double sum = r <= limited ? shortest * r : shortest * limited + 0.5 * perRadius * (r * r - limited * limited);
    return std::copysign(sum, radius);
  };
  return (integral(to) - integral(from)) / (to - from);
}

// Returns the integral of the time of a revolution over a piece, mm·min.
double revolutionsAlong(const ToolMove& move, const MovePiece& piece) {
  const double share = piece.to - piece.from, length = share * lengthOf(move);
  if (!move.isSurfaceSpeed) return length * revolutionAt(move, 0.0);
  if (move.turn == 0) return length * meanRevolution(move, pointOn(move, piece.from).x(), pointOn(move, piece.to).x());
  constexpr double kParts = 64.0;  // number of parts of a whole arc
  const int parts = std::max(1, static_cast<int>(std::ceil(kParts * share)));
  double mean = 0.0;
  for (int i = 0; i < parts; ++i) {
    const double at = piece.from + share * i / parts, next = piece.from + share * (i + 1) / parts;
    mean += meanRevolution(move, pointOn(move, at).x(), pointOn(move, next).x()) / parts;
  }
  return length * mean;
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
  if (!isPerRevolution(move)) return length / move.feed * 60.0;
  return revolutionsAlong(move, {}) / move.feed * 60.0;
}

double timeOf(const ToolMove& move, const MovePiece& piece) {
  if (!hasVaryingSpeed(move) || !(move.feed > 0.0)) return move.time * (piece.to - piece.from);
  return revolutionsAlong(move, piece) / move.feed * 60.0;
}

double spindleOf(const ToolMove& move, const MovePiece& piece) {
  if (move.spin == 0) return 0.0;
  if (!hasVaryingSpeed(move)) return spindleAt(move, pointOn(move, 0.5 * (piece.from + piece.to)).x());
  const double length = lengthOf(move) * (piece.to - piece.from);
  return length > 0.0 ? length / revolutionsAlong(move, piece) : spindleAt(move, pointOn(move, piece.from).x());
}

double lengthAfter(const ToolMove& move, double fractionOfTime) {
  if (!hasVaryingSpeed(move) || !(move.time > 0.0)) return fractionOfTime;
  double low = 0.0, high = 1.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    (timeOf(move, {0.0, middle}) < fractionOfTime * move.time ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

bool isStoppedByChange(const ToolPath& path, std::uint32_t line) {
  return std::any_of(path.moves.begin(), path.moves.end(), [&](const ToolMove& move) {
    return move.line == line && move.kind == ToolMove::Kind::Feed && move.isStoppedByChange;
  });
}

}  // namespace handwheel
