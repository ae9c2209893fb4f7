// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/Dimensions.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSame = 0.005;          // mm: sizes that a drawing shows alike
constexpr double kLargestChamfer = 5.0;  // mm
constexpr std::size_t kMostNotes = 40, kMostDiameters = 40;

bool isChamfer(const ProfileFeature& f) {
  return f.kind == ProfileFeature::Kind::Taper && std::abs(f.value - M_PI / 4) < 0.01 && f.length() < kLargestChamfer;
}

void addHeight(std::vector<double>& heights, double z) {
  for (const double known : heights)
    if (std::abs(known - z) < kSame) return;
  heights.push_back(z);
}

// Heights that a fillet or chamfer does not blur: flat faces, and where cylinders and tapers meet.
void addHeights(const std::vector<ProfileFeature>& features, bool isInner, std::vector<double>& heights) {
  const auto isSmall = [](const ProfileFeature& f) {
    return isChamfer(f) || (f.kind == ProfileFeature::Kind::Arc && f.value < kLargestChamfer);
  };
  for (std::size_t i = 0; i < features.size(); ++i) {
    const ProfileFeature& f = features[i];
    const bool isFace = f.kind == ProfileFeature::Kind::FlatFace;
    if (isFace) {
      // Between outer surfaces, or between inner ones, or an end of the part.
      const bool touchesInner =
          (i > 0 && features[i - 1].isInner) || (i + 1 < features.size() && features[i + 1].isInner);
      if (!isInner || touchesInner) addHeight(heights, f.low.y());
      continue;
    }
    if (f.isInner != isInner || isSmall(f)) continue;
    const auto isBlurred = [&](std::size_t k) { return k < features.size() && isSmall(features[k]); };
    const bool isUp = !f.isInner;
    if (!isBlurred(isUp ? i - 1 : i + 1)) addHeight(heights, f.low.y());
    if (!isBlurred(isUp ? i + 1 : i - 1)) addHeight(heights, f.high.y());
  }
}

std::string noteOf(const ProfileFeature& f) {
  if (f.kind == ProfileFeature::Kind::Arc) {
    const bool isBall = std::abs(f.centre.x()) < kSame;
    return (isBall ? "SR" : "R") + sizeText(f.value);
  }
  const double angle = f.value * 180.0 / M_PI;
  if (isChamfer(f)) return sizeText(f.length()) + "×45°";
  return "∠" + sizeText(2.0 * angle) + "°";
}

ProfilePoint middleOf(const ProfileFeature& f) {
  if (f.kind != ProfileFeature::Kind::Arc) return 0.5 * (f.low + f.high);
  const ProfilePoint chord = f.high - f.low;
  // On the arc, on the side of its chord on which it bulges: outside if convex, unless it is in a bore.
  const bool isOutwards = f.isConvex != f.isInner;
  const ProfilePoint out = (isOutwards ? 1.0 : -1.0) * ProfilePoint(chord.y(), -chord.x()).normalized();
  return f.centre + f.value * out;
}

}  // namespace

PartDimensions dimensionsOf(const TargetProfile& part, double tolerance) {
  const std::vector<ProfileFeature> features = featuresOf(part, tolerance);
  PartDimensions all;
  for (const ProfileFeature& f : features) {
    if (f.kind == ProfileFeature::Kind::Cylinder && all.diameters.size() < kMostDiameters)
      all.diameters.push_back({f.value, f.low.y(), f.high.y(), f.isInner});
    const bool hasNote = f.kind == ProfileFeature::Kind::Arc || f.kind == ProfileFeature::Kind::Taper;
    if (hasNote && all.notes.size() < kMostNotes) all.notes.push_back({middleOf(f), noteOf(f), f.isInner});
  }
  // The ends of tapers that no cylinder tells.
  for (const ProfileFeature& f : features) {
    if (f.kind != ProfileFeature::Kind::Taper || isChamfer(f)) continue;
    for (const ProfilePoint& end : {f.low, f.high}) {
      const bool isKnown = std::any_of(all.diameters.begin(), all.diameters.end(), [&](const auto& d) {
        return d.isInner == f.isInner && std::abs(d.value - 2.0 * end.x()) < kSame;
      });
      if (!isKnown && end.x() > kSame && all.diameters.size() < kMostDiameters)
        all.diameters.push_back({2.0 * end.x(), end.y(), end.y(), f.isInner});
    }
  }
  addHeight(all.outerHeights, part.lowerEnd());
  addHeight(all.outerHeights, part.upperEnd());
  addHeights(features, false, all.outerHeights);
  addHeights(features, true, all.innerHeights);
  for (auto* heights : {&all.outerHeights, &all.innerHeights}) std::sort(heights->begin(), heights->end());
  // Of a bore the outside tells the ends.
  std::erase_if(all.innerHeights, [&](double z) {
    return std::abs(z - part.lowerEnd()) < kSame || std::abs(z - part.upperEnd()) < kSame;
  });
  return all;
}

}  // namespace handwheel
