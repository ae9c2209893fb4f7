// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/TurnedPartDisplay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace handwheel {

namespace {

constexpr std::array<float, 3> kDull{0.50f, 0.51f, 0.53f}, kBright{0.88f, 0.90f, 0.93f};
constexpr float kMostGloss = 0.7f;

// 0: as rough as N10, 1: as fine as N4. None: nothing is known of these samples.
std::optional<float> meanGloss(const TurnedProfile& profile, const SurfaceFinish& finish,
                               const TurnedProfile::Range& samples) {
  constexpr float kRough = 12.5f, kPolished = 0.2f;  // µm
  constexpr std::size_t kStride = 8;                 // it is asked for each frame
  const float whole = std::log(kRough / kPolished);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = samples.first; i < samples.last; i += kStride) {
    const FinishMark mark = finish.at(TurningSide::Outside, i);
    if (!mark.isKnown() || !profile.hasMaterial(i)) continue;
    sum += std::log(kRough / std::clamp(mark.roughness, kPolished, kRough)) / whole;
    ++count;
  }
  return count > 0 ? std::optional(static_cast<float>(sum / count)) : std::nullopt;
}

// The triangles of a soup that go beyond a height, or the others. At this height there is a ring of points: no triangle
// is on both sides.
std::shared_ptr<const TriangleSoup> sideOf(const TriangleSoup& soup, double height, bool isAbove) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  auto side = std::make_shared<TriangleSoup>();
  std::vector<std::uint32_t> indices(soup.points.size(), kUnused);
  for (Triangle triangle : soup.triangles) {
    const bool isBeyond = std::any_of(triangle.begin(), triangle.end(),
                                      [&](std::uint32_t corner) { return soup.points[corner].z() > height; });
    if (isBeyond != isAbove) continue;
    for (std::uint32_t& corner : triangle) {
      std::uint32_t& index = indices[corner];
      if (index == kUnused) {
        index = static_cast<std::uint32_t>(side->points.size());
        side->points.push_back(soup.points[corner]);
      }
      corner = index;
    }
    side->triangles.push_back(triangle);
  }
  return side;
}

}  // namespace

DisplayModel displayOf(const TurnedSurface& surface, double base) {
  DisplayModel model;
  for (std::size_t b = 0; b < surface.blocks().size(); ++b) {
    DisplayPart part;
    part.name = "block." + std::to_string(b);
    part.group = kStockGroup;
    part.soup = surface.blocks()[b];
    part.pose.translation().z() = base;
    model.parts.push_back(std::move(part));
  }
  return model;
}

void showFinish(DisplayModel& model, const TurnedProfile& profile, const SurfaceFinish& finish) {
  constexpr std::size_t kBlock = TurnedSurface::kBlockSamples;
  for (std::size_t b = 0; b < model.parts.size(); ++b) {
    const auto share = meanGloss(profile, finish, {b * kBlock, std::min((b + 1) * kBlock, profile.size())});
    if (!share) continue;
    DisplayPart& part = model.parts[b];
    part.gloss = std::lerp(0.0f, kMostGloss, *share);
    for (std::size_t c = 0; c < 3; ++c) part.colour[c] = std::lerp(kDull[c], kBright[c], *share);
  }
}

PartedBlock showPartedOff(DisplayModel& model, const TurnedProfile& profile, PartedBlock before) {
  const std::vector<TurnedProfile::Range> pieces = profile.pieces();
  if (pieces.size() < 2) return {};
  constexpr std::size_t kBlock = TurnedSurface::kBlockSamples;
  const std::size_t end = pieces.front().last;  // the first sample that has nothing
  const std::size_t count = model.parts.size();
  for (std::size_t b = 0; b < count; ++b) {
    DisplayPart& part = model.parts[b];
    if ((b + 1) * kBlock <= end) continue;
    if (b * kBlock >= end) {
      part.group = kPartedGroup;
      continue;
    }
    if (before.whole != part.soup || before.z != profile.z(end)) {
      const double z = profile.z(end);
      before = {part.soup, sideOf(*part.soup, z, false), sideOf(*part.soup, z, true), z};
    }
    part.soup = before.held;
    if (before.parted->triangles.empty()) continue;
    DisplayPart parted = part;
    parted.name = "parted." + std::to_string(b);
    parted.group = kPartedGroup;
    parted.soup = before.parted;
    model.parts.push_back(std::move(parted));
  }
  return before;
}

}  // namespace handwheel
