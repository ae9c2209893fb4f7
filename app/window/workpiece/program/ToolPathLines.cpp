// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/ToolPathLines.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kPathChord = 0.02;  // mm, of arcs
constexpr int kMostArcPoints = 360;  // limit per move
constexpr std::size_t kMostPathPoints = 400'000;
constexpr int kNosePoints = 24;
constexpr double kInsert = 6.0;  // mm, edge of the drawn insert

PathLine::Look lookOf(const ToolMove& move) {
  if (move.kind == ToolMove::Kind::Rapid) return PathLine::Look::Rapid;
  return move.kind == ToolMove::Kind::Thread ? PathLine::Look::Thread : PathLine::Look::Feed;
}

int pointsOf(const ToolMove& move) {
  if (move.turn == 0) return 1;
  const double radius = std::max((move.from - move.centre).norm(), kPathChord);
  const double step = 2.0 * std::acos(1.0 - kPathChord / radius * 0.5);
  return std::clamp(static_cast<int>(std::ceil(std::abs(sweepOf(move)) / step)), 2, kMostArcPoints);
}

}  // namespace

PathLayer::Lines toolPathLines(const ToolPath& path, double zero, double dash) {
  const auto placed = [zero](const ProfilePoint& p) { return Vec3(p.x(), 0.0, zero + p.y()); };
  std::array<std::vector<PathLine>, PathLine::kLooks> byLook;
  PathLine line;
  std::size_t points = 0;
  const auto finish = [&] {
    if (line.points.size() > 1) {
      std::vector<PathLine>& all = byLook[static_cast<std::size_t>(line.look)];
      if (line.look == PathLine::Look::Rapid) {
        const std::vector<PathLine> dashes = dashed(line, dash);
        points += 2 * dashes.size();
        all.insert(all.end(), dashes.begin(), dashes.end());
      } else {
        points += line.points.size();
        all.push_back(std::move(line));
      }
    }
    line = {};
  };
  for (const ToolMove& move : path.moves) {
    if (move.kind == ToolMove::Kind::Dwell) continue;
    if (points > kMostPathPoints) break;
    if (line.points.empty() || line.look != lookOf(move) || line.points.size() > 1000) {
      finish();
      line.look = lookOf(move);
      line.points.push_back(placed(move.from));
    }
    const int count = pointsOf(move);
    for (int i = 1; i <= count; ++i) line.points.push_back(placed(pointOn(move, static_cast<double>(i) / count)));
  }
  finish();
  auto all = std::make_shared<std::vector<PathLine>>();
  for (std::vector<PathLine>& each : byLook)
    all->insert(all->end(), std::make_move_iterator(each.begin()), std::make_move_iterator(each.end()));
  return all;
}

std::vector<std::vector<Vec3>> toolOutline(const ProgramTool& tool, ProgramDialect dialect, const ProfilePoint& tip,
                                           double zero) {
  const ProfilePoint toTip = tipDirection(dialect, tool.orientation);
  const auto placed = [&](const ProfilePoint& p) { return Vec3(p.x(), 0.0, zero + p.y()); };
  std::vector<std::vector<Vec3>> outlines;
  const ProfilePoint centre = tip - tool.noseRadius * toTip;
  if (tool.noseRadius > 0.0) {
    std::vector<Vec3>& nose = outlines.emplace_back();
    for (int i = 0; i < kNosePoints; ++i) {
      const double angle = 2.0 * M_PI * i / kNosePoints;
      nose.push_back(placed(centre + tool.noseRadius * ProfilePoint(std::cos(angle), std::sin(angle))));
    }
  }
  // The insert: a rhomb of 55 degrees away from the tip.
  const ProfilePoint away = toTip.norm() > 0.0 ? ProfilePoint(-toTip.normalized()) : ProfilePoint(1.0, 0.0);
  const ProfilePoint across(-away.y(), away.x());
  const double along = std::cos(27.5 * M_PI / 180.0) * kInsert, beside = std::sin(27.5 * M_PI / 180.0) * kInsert;
  outlines.push_back({placed(tip), placed(tip + along * away + beside * across), placed(tip + 2.0 * along * away),
                      placed(tip + along * away - beside * across)});
  return outlines;
}

}  // namespace handwheel
