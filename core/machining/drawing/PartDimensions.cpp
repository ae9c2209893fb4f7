// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/Dimensions.h"
#include "machining/refit/SampledProfile.h"
#include "machining/target/files/DrawingWriter.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSameSize = 0.005;           // mm; sizes that a drawing shows as equal
constexpr double kLargestChamfer = 5.0;       // mm
constexpr double kTolerancedDistance = 0.51;  // mm; distance within which a surface has a tolerance

bool isChamfer(const ProfileFeature& f) {
  return f.kind == ProfileFeature::Kind::Taper && std::abs(f.value - M_PI / 4) < 0.01 && f.length() < kLargestChamfer;
}

void addHeight(std::vector<double>& heights, double z, double least) {
  for (const double known : heights)
    if (std::abs(known - z) < std::max(kSameSize, least)) return;
  heights.push_back(z);
}

// Adds the heights that a fillet or chamfer does not blur: flat faces, and the joints of cylinders and tapers. Faces
// come first, since nearly equal heights count as one.
void addHeights(const std::vector<ProfileFeature>& features, bool isInner, double least, std::vector<double>& heights) {
  const auto isSmall = [](const ProfileFeature& f) {
    return isChamfer(f) || (f.kind == ProfileFeature::Kind::Arc && f.value < kLargestChamfer);
  };
  const auto isOf = [&](std::size_t k, bool side) {
    return k < features.size() && features[k].kind != ProfileFeature::Kind::FlatFace && features[k].isInner == side;
  };
  for (std::size_t i = 0; i < features.size(); ++i) {
    const bool isFace = features[i].kind == ProfileFeature::Kind::FlatFace;
    if (isFace && (isOf(i - 1, isInner) || isOf(i + 1, isInner))) addHeight(heights, features[i].low.y(), least);
  }
  for (std::size_t i = 0; i < features.size(); ++i) {
    const ProfileFeature& f = features[i];
    if (f.kind == ProfileFeature::Kind::FlatFace || f.isInner != isInner || isSmall(f)) continue;
    const auto isBlurred = [&](std::size_t k) { return k < features.size() && isSmall(features[k]); };
    const bool isUp = !f.isInner;
    if (!isBlurred(isUp ? i - 1 : i + 1)) addHeight(heights, f.low.y(), least);
    if (!isBlurred(isUp ? i + 1 : i - 1)) addHeight(heights, f.high.y(), least);
  }
}

// Returns true if a side leans by less than 3°, and by no more than twice the least drawn size.
bool leansLittle(double extent, double along, double least) {
  return std::abs(extent) <= 2.0 * least && 20.0 * std::abs(extent) < std::abs(along);
}

// Returns a feature that is flat within the least drawn size as flat.
ProfileFeature straightened(ProfileFeature f, double least) {
  const ProfilePoint along = f.high - f.low;
  const double chord = along.norm(), half = 0.5 * chord;
  if (f.kind == ProfileFeature::Kind::Arc) {
    const double rise = f.value - std::sqrt(std::max(0.0, (f.value - half) * (f.value + half)));
    if (!(chord < f.value) || rise > least) return f;
    f.kind = ProfileFeature::Kind::Taper;
    f.value = std::atan2(std::abs(along.x()), std::abs(along.y()));
  }
  if (f.kind != ProfileFeature::Kind::Taper) return f;
  const bool isSteep = std::abs(along.y()) <= least && std::abs(along.x()) > std::abs(along.y());
  if (isSteep || leansLittle(along.y(), along.x(), least)) {
    f.kind = ProfileFeature::Kind::FlatFace;
    f.isInner = false;
    if (f.low.x() > f.high.x()) std::swap(f.low, f.high);  // nearer to the axis
  } else if (std::abs(along.x()) <= 0.5 * least || leansLittle(along.x(), along.y(), 0.5 * least)) {
    f.kind = ProfileFeature::Kind::Cylinder;
    f.value = f.low.x() + f.high.x();
  }
  return f;
}

std::string noteOf(const ProfileFeature& f, const DrawingTitle& title) {
  if (f.kind == ProfileFeature::Kind::Arc) {
    const bool isBall = std::abs(f.centre.x()) < kLeastDrawn;
    return toleratedText(title, DrawnTolerance::Of::Radius, f.value, f.low.y(), f.high.y(), isBall ? "SR" : "R");
  }
  const double angle = f.value * 180.0 / M_PI;
  if (isChamfer(f)) return sizeText(f.length()) + "×45°";
  return "∠" + sizeText(2.0 * angle) + "°";
}

ProfilePoint middleOf(const ProfileFeature& f) {
  if (f.kind != ProfileFeature::Kind::Arc) return 0.5 * (f.low + f.high);
  const ProfilePoint chord = f.high - f.low;
  // The note stands on the arc, on the convex side of its chord: outside if convex, unless it is in a bore.
  const bool isOutwards = f.isConvex != f.isInner;
  const ProfilePoint out = (isOutwards ? 1.0 : -1.0) * ProfilePoint(chord.y(), -chord.x()).normalized();
  return f.centre + f.value * out;
}

// Returns the thread whose crest has this diameter.
const DrawnThread* threadOn(const DrawingTitle& title, const ProfileFeature& f) {
  for (const DrawnThread& t : title.threads) {
    const double common = std::min(t.high, f.high.y()) - std::max(t.low, f.low.y());
    const double depth = std::abs(t.major - t.minor), crest = t.isInner ? t.minor : t.major;
    if (t.isInner == f.isInner && common > 0.5 * f.length() && std::abs(f.value - crest) < 0.5 * depth) return &t;
  }
  return nullptr;
}

void addDiameters(const std::vector<ProfileFeature>& features, const DrawingTitle& title, PartDimensions& all) {
  for (const ProfileFeature& f : features) {
    if (f.kind != ProfileFeature::Kind::Cylinder) continue;
    const auto of = f.isInner ? DrawnTolerance::Of::Bore : DrawnTolerance::Of::Diameter;
    const DrawnThread* const thread = threadOn(title, f);
    all.diameters.push_back(
        {f.value, f.low.y(), f.high.y(), f.isInner,
         thread ? thread->designation : toleratedText(title, of, f.value, f.low.y(), f.high.y(), "Ø")});
  }
  // Adds the ends of tapers that no cylinder defines.
  for (const ProfileFeature& f : features) {
    if (f.kind != ProfileFeature::Kind::Taper || isChamfer(f)) continue;
    for (const ProfilePoint& end : {f.low, f.high}) {
      const double d = 2.0 * end.x();
      const bool isKnown = std::any_of(all.diameters.begin(), all.diameters.end(), [&](const auto& known) {
        return known.isInner == f.isInner && std::abs(known.value - d) < kSameSize;
      });
      if (!isKnown && d > kSameSize) all.diameters.push_back({d, end.y(), end.y(), f.isInner, "Ø" + sizeText(d)});
    }
  }
}

// Adds toleranced diameters that no cylinder shows: of a waist, or of a stem within a free form.
void addAsked(const TargetProfile& part, const DrawingTitle& title, PartDimensions& all) {
  for (const DrawnTolerance& t : title.tolerances) {
    const bool isInner = t.of == DrawnTolerance::Of::Bore;
    if (!(t.high > t.low) || (!isInner && t.of != DrawnTolerance::Of::Diameter)) continue;
    const auto extent = part.extentAt(0.5 * (t.low + t.high));
    const double value = extent ? 2.0 * (isInner ? extent->inner : extent->outer) : 0.0;
    if (std::abs(value - t.size) >= kTolerancedDistance) continue;
    const std::string text = toleratedText(title, t.of, value, t.low, t.high, "Ø");
    const bool isShown =
        std::any_of(all.diameters.begin(), all.diameters.end(), [&](const auto& d) { return d.text == text; });
    if (!isShown) all.diameters.push_back({value, t.low, t.high, isInner, text});
  }
}

// Adds the roughness at the longest surface of each.
void addRoughness(const std::vector<ProfileFeature>& features, const DrawingTitle& title, PartDimensions& all) {
  for (const DrawnRoughness& rough : title.roughness) {
    const auto common = [&](const ProfileFeature& f) {
      const bool isMeant = f.isInner == rough.isInner && f.kind != ProfileFeature::Kind::FlatFace;
      return isMeant ? std::min(rough.high, f.high.y()) - std::max(rough.low, f.low.y()) : 0.0;
    };
    const auto longest =
        std::max_element(features.begin(), features.end(),
                         [&](const ProfileFeature& a, const ProfileFeature& b) { return common(a) < common(b); });
    if (longest == features.end() || !(common(*longest) > 0.0)) continue;
    // Off the middle, where other leaders begin.
    const ProfilePoint at = longest->kind == ProfileFeature::Kind::Arc
                                ? middleOf(*longest)
                                : ProfilePoint(longest->low + 0.75 * (longest->high - longest->low));
    all.notes.push_back({at, "Ra " + sizeText(rough.ra), true});
  }
}

// Adds lengths with a tolerance that the lengths from the upper end do not show.
void addSpans(const DrawingTitle& title, double upperEnd, PartDimensions& all) {
  const auto heightAt = [&](double z) -> std::optional<double> {
    for (const double height : all.outerHeights)
      if (std::abs(height - z) < kTolerancedDistance) return height;
    return std::nullopt;
  };
  for (const DrawnTolerance& t : title.tolerances) {
    if (t.of != DrawnTolerance::Of::Length || !(t.high > t.low) || std::abs(t.high - upperEnd) < kTolerancedDistance)
      continue;
    const auto from = heightAt(t.low), to = heightAt(t.high);
    if (from && to && *to > *from)
      all.spans.push_back({*from, *to, toleratedText(title, t.of, *to - *from, *from, *to, {})});
  }
}

}  // namespace

std::string toleratedText(const DrawingTitle& title, DrawnTolerance::Of of, double value, double low, double high,
                          const std::string& prefix) {
  constexpr double kNominal = 0.051;  // mm; deviation of a made part from its nominal size
  for (const DrawnTolerance& t : title.tolerances) {
    const bool isPlaced = t.high > t.low, isLength = of == DrawnTolerance::Of::Length;
    if (t.of != of || std::abs(t.size - value) >= (isPlaced ? kTolerancedDistance : kNominal)) continue;
    const bool isHere =
        isLength ? std::abs(low - t.low) < kTolerancedDistance && std::abs(high - t.high) < kTolerancedDistance
                 : std::min(high, t.high) - std::max(low, t.low) > 0.5 * std::min(high - low, t.high - t.low);
    if (!isPlaced || isHere) return prefix + sizeText(t.size) + " " + t.text;
  }
  return prefix + sizeText(value);
}

PartDimensions dimensionsOf(const TargetProfile& part, const DrawingTitle& title, double tolerance, double least,
                            bool isSmoothed) {
  std::vector<ProfileFeature> features = featuresOf(part, tolerance);
  if (isSmoothed) {
    for (ProfileFeature& f : features) f = straightened(f, least);
  }
  std::erase_if(features, [&](const ProfileFeature& f) { return (f.high - f.low).norm() < least; });
  PartDimensions all;
  addDiameters(features, title, all);
  addAsked(part, title, all);
  for (const ProfileFeature& f : features) {
    const bool hasNote = f.kind == ProfileFeature::Kind::Arc || f.kind == ProfileFeature::Kind::Taper;
    if (hasNote) all.notes.push_back({middleOf(f), noteOf(f, title)});
  }
  addRoughness(features, title, all);
  addHeight(all.outerHeights, part.lowerEnd(), least);
  addHeight(all.outerHeights, part.upperEnd(), least);
  addHeights(features, false, least, all.outerHeights);
  addHeights(features, true, least, all.innerHeights);
  for (auto* heights : {&all.outerHeights, &all.innerHeights}) std::sort(heights->begin(), heights->end());
  // The outside defines the ends of a bore.
  std::erase_if(all.innerHeights, [&](double z) {
    return std::abs(z - part.lowerEnd()) < least || std::abs(z - part.upperEnd()) < least;
  });
  addSpans(title, part.upperEnd(), all);
  return all;
}

std::optional<TargetProfile> withoutSmall(const TargetProfile& part, double least) {
  constexpr double kSteps = 10.0;  // number of samples along the least drawn size
  const Result<TargetProfile> smooth = sectionOf(sampled(part, least / kSteps), 0.5 * least);
  if (!smooth) return std::nullopt;
  TargetProfile placed = smooth->moved(part.lowerEnd());
  // Undercuts are not in samples.
  return distanceBetween(part, placed) <= 2.0 * least ? std::optional(std::move(placed)) : std::nullopt;
}

}  // namespace handwheel
