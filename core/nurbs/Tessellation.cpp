// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "nurbs/Tessellation.h"

#include "base/NumberText.h"
#include "nurbs/RingLayout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kFinest = 1e-15;  // share of the part's size that rounding needs

void addRing(TriangleSoup& soup, const Ring& ring) {
  for (std::uint32_t i = 0; i < ring.segments; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / ring.segments;
    soup.points.emplace_back(ring.radius * std::cos(angle), ring.radius * std::sin(angle), ring.z);
  }
}

// Adds triangles between two neighbouring rings, given with the index of their first vertex; the profile runs from low
// to high.
void addBand(TriangleSoup& soup, const Ring& low, std::uint32_t lowFirst, const Ring& high, std::uint32_t highFirst) {
  const auto l = [&](std::uint32_t i) { return lowFirst + i % low.segments; };
  const auto h = [&](std::uint32_t i) { return highFirst + i % high.segments; };
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) { soup.triangles.push_back({a, b, c}); };
  const std::uint32_t most = std::max(low.segments, high.segments), least = std::min(low.segments, high.segments);
  if (most == 1) return;
  if (least == 1) {
    for (std::uint32_t i = 0; i < most; ++i) {
      if (low.segments == 1) add(l(0), h(i + 1), h(i));
      if (high.segments == 1) add(l(i), l(i + 1), h(0));
    }
    return;
  }
  for (std::uint32_t i = 0; i < least; ++i) {
    if (low.segments == high.segments) {
      add(l(i), l(i + 1), h(i + 1));
      add(l(i), h(i + 1), h(i));
    } else if (low.segments == most) {  // twice as many as high
      add(l(2 * i), l(2 * i + 1), h(i));
      add(l(2 * i + 1), h(i + 1), h(i));
      add(l(2 * i + 1), l(2 * i + 2), h(i + 1));
    } else {
      add(l(i), h(2 * i + 1), h(2 * i));
      add(l(i), l(i + 1), h(2 * i + 1));
      add(l(i + 1), h(2 * i + 2), h(2 * i + 1));
    }
  }
}

// Returns the finest tolerance with few enough triangles, up to a factor of two.
Error tooFine(const ProfileCurve& profile, const TessellationOptions& options, Progress progress) {
  double size = 0.0;
  for (const ProfilePoint& pole : profile.nurbs().poles) size = std::max(size, pole.x());
  TessellationOptions coarser = options;
  coarser.chord = std::max(options.chord, kFinest * size);
  Result<std::vector<Ring>> rings = Error{};
  do {
    coarser.chord *= 2.0;
    rings = computeRings(profile, coarser, progress);
  } while (!rings && rings.error().code == ErrorCode::FileTooLarge &&
           coarser.chord < TessellationOptions::kLargestChord);
  if (!rings) return rings.error();
  return {ErrorCode::ValueOutOfRange,
          {"chord tolerance", roundedText(options.chord), roundedText(coarser.chord),
           roundedText(TessellationOptions::kLargestChord)},
          {},
          {}};
}

}  // namespace

Result<TriangleSoup> tessellate(const ProfileCurve& profile, const TessellationOptions& options, Progress progress) {
  if (!(options.chord > 0.0 && options.chord <= TessellationOptions::kLargestChord)) {
    return Error{ErrorCode::ValueOutOfRange,
                 {"chord tolerance", roundedText(options.chord), "0", roundedText(TessellationOptions::kLargestChord)},
                 {},
                 {}};
  }
  const auto rings = computeRings(profile, options, progress);
  if (!rings && rings.error().code == ErrorCode::FileTooLarge) return tooFine(profile, options, progress);
  if (!rings) return rings.error();

  std::size_t points = 0, triangles = 0;
  for (std::size_t i = 0; i < rings->size(); ++i) {
    points += (*rings)[i].segments;
    if (i > 0) triangles += bandTriangles((*rings)[i - 1], (*rings)[i]);
  }
  TriangleSoup soup;
  soup.points.reserve(points);
  soup.triangles.reserve(triangles);
  for (std::size_t i = 0; i < rings->size(); ++i) {
    const Ring& ring = (*rings)[i];
    const bool isFirstAgain = profile.isClosed() && i + 1 == rings->size();
    const auto end = static_cast<std::uint32_t>(soup.points.size());
    const std::uint32_t first = isFirstAgain ? 0 : end;
    if (!isFirstAgain) addRing(soup, ring);
    if (i > 0) {
      const Ring& before = (*rings)[i - 1];
      addBand(soup, before, end - before.segments, ring, first);
    }
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    progress.set(static_cast<double>(i + 1) / static_cast<double>(rings->size()));
  }
  return soup;
}

}  // namespace handwheel
