// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/TaperMeasure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace handwheel {

namespace {

using Points = std::span<const ProfilePoint>;

constexpr double kTaperRounding = 1e-9;  // mm, rounding of positions that users type
constexpr double kFaceSlope = 6.0;       // r over z between two samples; a steeper slope is a face
// A neighbour does not belong to the taper if its slope differs by half of that slope, and by half a degree: hands are
// unsteady.
constexpr double kOtherShare = 0.5, kOtherSlope = 0.00873;
// A side within this distance of a line has ends only if the other lines leave almost nothing of the distances: this
// excludes feed marks, but finds a cylinder of a few samples beside a shallow taper.
constexpr double kStraight = 2e-3, kExactTaper = 1e-7;  // mm, root mean square; kExactTaper is rounding
constexpr double kClearlyBetter = 0.01;

// The samples [first, last) of a line.
struct Piece {
  std::size_t first = 0, last = 0;
  double slope = 0.0;
  double squares = 0.0;  // mm²; squared distances in r

  std::size_t size() const { return last - first; }
};

// Sums over the first samples, so that the line through any piece costs O(1). About the mean, against cancellation.
class LineSums {
 public:
  explicit LineSums(Points points) : m_sums(points.size() + 1) {
    ProfilePoint mean(0.0, 0.0);
    for (const ProfilePoint& p : points) mean += p / static_cast<double>(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double r = points[i].x() - mean.x(), z = points[i].y() - mean.y();
      m_sums[i + 1] = {m_sums[i][0] + r, m_sums[i][1] + z, m_sums[i][2] + z * z, m_sums[i][3] + r * z,
                       m_sums[i][4] + r * r};
    }
  }

  Piece fit(std::size_t first, std::size_t last) const {
    Piece piece{first, last};
    if (piece.size() < 2) return piece;
    std::array<double, 5> s{};
    for (std::size_t k = 0; k < s.size(); ++k) s[k] = m_sums[last][k] - m_sums[first][k];
    const auto n = static_cast<double>(piece.size());
    const double zz = s[2] - s[1] * s[1] / n, rz = s[3] - s[0] * s[1] / n, rr = s[4] - s[0] * s[0] / n;
    piece.slope = rz / zz;
    piece.squares = std::max(0.0, rr - rz * piece.slope);
    return piece;
  }

 private:
  std::vector<std::array<double, 5>> m_sums;  // sums of r, z, z², r z, r²
};

using Pieces = std::array<Piece, 3>;

double squaresOf(const Pieces& pieces) {
  return pieces[0].squares + pieces[1].squares + pieces[2].squares;
}

// Finds the (up to) three consecutive lines that are nearest to the samples. Tries 64 positions first, then those
// between them.
Pieces bestLines(const LineSums& sums, std::size_t count) {
  const auto cut = [&](std::size_t i, std::size_t j) {
    return Pieces{sums.fit(0, i), sums.fit(i, j), sums.fit(j, count)};
  };
  std::size_t step = std::max<std::size_t>(1, count / 64);
  Pieces best = cut(0, count);
  const auto offer = [&](std::size_t i, std::size_t j) {
    if (i > j || j > count) return;
    const Pieces offered = cut(i, j);
    if (squaresOf(offered) < squaresOf(best)) best = offered;
  };
  for (std::size_t i = 0; i < count; i += step) {
    for (std::size_t j = i + step; j <= count; j += step) offer(i, j);
  }
  while (step > 1) {
    step = (step + 1) / 2;
    const std::size_t first = best[0].last, second = best[1].last;
    for (const std::size_t i : {first - std::min(first, step), first, first + step}) {
      for (const std::size_t j : {second - std::min(second, step), second, second + step}) offer(i, j);
    }
  }
  return best;
}

double riseOf(const Piece& piece, double spacing) {
  return std::abs(piece.slope) * spacing * static_cast<double>(piece.size());
}

// The taper among samples without a face between them.
Piece taperOf(Points points, double spacing) {
  const LineSums sums(points);
  const Piece whole = sums.fit(0, points.size());
  const auto isWithin = [&](double distance) {
    return whole.squares <= distance * distance * static_cast<double>(whole.size());
  };
  if (isWithin(kExactTaper)) return whole;
  const Pieces pieces = bestLines(sums, points.size());
  if (isWithin(kStraight) && squaresOf(pieces) > kClearlyBetter * whole.squares) return whole;
  const auto steepest = std::max_element(pieces.begin(), pieces.end(), [&](const Piece& a, const Piece& b) {
    return riseOf(a, spacing) < riseOf(b, spacing);
  });
  const auto isOfIt = [&](const Piece& other) {
    const double difference = std::abs(other.slope - steepest->slope);
    return difference <= std::max(kOtherShare * std::abs(steepest->slope), kOtherSlope);
  };
  auto first = steepest, last = steepest;
  while (first != pieces.begin() && isOfIt(*std::prev(first))) --first;
  while (std::next(last) != pieces.end() && isOfIt(*std::next(last))) ++last;
  return sums.fit(first->first, last->last);
}

TaperReading readingOf(Points points, const Piece& piece) {
  const Points taper = points.subspan(piece.first, piece.size());
  ProfilePoint mean(0.0, 0.0);
  for (const ProfilePoint& p : taper) mean += p;
  mean /= static_cast<double>(taper.size());
  double zz = 0.0, rz = 0.0;  // once more, without the rounding of the sums
  for (const ProfilePoint& p : taper) {
    zz += (p.y() - mean.y()) * (p.y() - mean.y());
    rz += (p.x() - mean.x()) * (p.y() - mean.y());
  }
  const double slope = rz / zz;
  TaperReading reading{std::atan(slope), 0.0, {taper.front().y(), taper.back().y()}, mean.x()};
  for (const ProfilePoint& p : taper)
    reading.deviation = std::max(reading.deviation, std::abs(p.x() - mean.x() - slope * (p.y() - mean.y())));
  return reading;
}

}  // namespace

std::optional<TaperReading> measureTaper(const TurnedProfile& profile, TurningSide side, AxisRange range) {
  const bool isOutside = side == TurningSide::Outside;
  std::vector<ProfilePoint> run;  // samples without a face or a gap between them
  std::optional<TaperReading> found;
  double rise = -1.0;
  const auto endRun = [&] {
    if (run.size() >= 2) {
      const Piece piece = taperOf(run, profile.spacing());
      if (const double r = riseOf(piece, profile.spacing()); piece.size() >= 2 && r > rise) {
        rise = r;
        found = readingOf(run, piece);
      }
    }
    run.clear();
  };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    if (!(profile.z(i) >= range.from - kTaperRounding && profile.z(i) <= range.to + kTaperRounding)) continue;
    const ProfilePoint p(isOutside ? profile.radius(i) : profile.inner(i), profile.z(i));
    const bool isThere = profile.hasMaterial(i) && (isOutside || p.x() > 0.0);
    if (!run.empty() && (!isThere || std::abs(p.x() - run.back().x()) > kFaceSlope * profile.spacing())) endRun();
    if (isThere) run.push_back(p);
  }
  endRun();
  return found;
}

}  // namespace handwheel
