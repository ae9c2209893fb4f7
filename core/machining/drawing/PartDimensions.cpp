// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/Dimensions.h"
#include "machining/drawing/DrawnOutline.h"
#include "machining/refit/SampledProfile.h"
#include "machining/target/files/DrawingWriter.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSameSize = 0.005;           // mm; sizes that a drawing shows as equal
constexpr double kTolerancedDistance = 0.51;  // mm; distance within which a surface has a tolerance

void addHeight(std::vector<double>& heights, double z, double least) {
  for (const double known : heights)
    if (std::abs(known - z) < std::max(kSameSize, least)) return;
  heights.push_back(z);
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
    if (f.low.x() > f.high.x()) {  // `low` is nearer to the axis
      std::swap(f.low, f.high);
      f.isDownwards = !f.isDownwards;
    }
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

// Returns a point halfway between the middle and the upper end of a feature.
ProfilePoint besideMiddle(const ProfileFeature& f) {
  const ProfilePoint between = 0.5 * (middleOf(f) + f.high);
  return f.kind == ProfileFeature::Kind::Arc ? ProfilePoint(f.centre + f.value * (between - f.centre).normalized())
                                             : between;
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

// Returns true if two cylinders of one diameter are one that a groove interrupts. It is no longer than either of them.
bool areOne(const std::vector<ProfileFeature>& features, const ProfileFeature& a, const PartDimensions::Diameter& b) {
  const double from = std::min(a.high.y(), b.high), to = std::max(a.low.y(), b.low);
  if (a.isInner != b.isInner || std::abs(a.value - b.value) > kSameSize || to < from ||
      to - from > std::min(a.length(), b.high - b.low))
    return false;
  return std::all_of(features.begin(), features.end(), [&](const ProfileFeature& f) {
    const bool isBetween = f.isInner == a.isInner && f.kind != ProfileFeature::Kind::FlatFace &&
                           f.low.y() >= from - kSameSize && f.high.y() <= to + kSameSize;
    const double r = 0.5 * a.value, middle = middleOf(f).x();
    return !isBetween || (a.isInner ? std::min({f.low.x(), f.high.x(), middle}) > r - kSameSize
                                    : std::max({f.low.x(), f.high.x(), middle}) < r + kSameSize);
  });
}

// isSmoothed: leaves out the ends of arcs, which are the marks of a hand.
void addDiameters(const DrawnOutline& outline, const DrawingTitle& title, bool isSmoothed, PartDimensions& all) {
  for (const ProfileFeature& f : outline.features()) {
    if (f.kind != ProfileFeature::Kind::Cylinder) continue;
    const auto of = f.isInner ? DrawnTolerance::Of::Bore : DrawnTolerance::Of::Diameter;
    const DrawnThread* const thread = threadOn(title, f);
    const std::string text =
        thread ? thread->designation : toleratedText(title, of, f.value, f.low.y(), f.high.y(), "Ø");
    const bool isKnown = std::any_of(all.diameters.begin(), all.diameters.end(), [&](const auto& known) {
      return known.text == text && areOne(outline.features(), f, known);
    });
    if (!isKnown) all.diameters.push_back({f.value, f.low.y(), f.high.y(), f.isInner, text});
  }
  // Adds the ends of tapers and arcs, and the widest and narrowest points of arcs, that no cylinder defines.
  const auto add = [&](const ProfileFeature& f, const ProfilePoint& at) {
    const double d = 2.0 * at.x();
    const bool isKnown = std::any_of(all.diameters.begin(), all.diameters.end(), [&](const auto& known) {
      return known.isInner == f.isInner && std::abs(known.value - d) < kSameSize;
    });
    if (!isKnown && d > kSameSize) all.diameters.push_back({d, at.y(), at.y(), f.isInner, "Ø" + sizeText(d)});
  };
  for (std::size_t i = 0; i < outline.features().size(); ++i) {
    const ProfileFeature& f = outline.features()[i];
    if (isSmoothed && f.kind == ProfileFeature::Kind::Arc) continue;
    for (const bool atEnd : {f.isDownwards, !f.isDownwards}) {
      if (outline.needsDiameter(i, atEnd)) add(f, atEnd ? f.end() : f.start());
    }
    if (const auto extreme = outline.extremeOf(i)) add(f, *extreme);
  }
}

// Adds threads, and toleranced diameters, that no cylinder shows: of a waist, or of a stem within a free form. A waist
// of an arc gets its tolerance.
void addAsked(const TargetProfile& part, const DrawingTitle& title, PartDimensions& all) {
  for (const DrawnTolerance& t : title.tolerances) {
    const bool isInner = t.of == DrawnTolerance::Of::Bore;
    if (!(t.high > t.low) || (!isInner && t.of != DrawnTolerance::Of::Diameter)) continue;
    const auto extent = part.extentAt(0.5 * (t.low + t.high));
    const double value = extent ? 2.0 * (isInner ? extent->inner : extent->outer) : 0.0;
    if (std::abs(value - t.size) >= kTolerancedDistance) continue;
    const std::string text = toleratedText(title, t.of, value, t.low, t.high, "Ø");
    const auto shown = std::find_if(all.diameters.begin(), all.diameters.end(), [&](const auto& d) {
      const bool isHere = d.low == d.high && d.low >= t.low && d.low <= t.high;
      return d.text == text || (d.isInner == isInner && isHere && std::abs(d.value - value) < kSameSize);
    });
    if (shown != all.diameters.end())
      shown->text = text;
    else
      all.diameters.push_back({value, t.low, t.high, isInner, text});
  }
  // A thread along a small part of a cylinder.
  for (const DrawnThread& t : title.threads) {
    const bool isShown = std::any_of(all.diameters.begin(), all.diameters.end(), [&](const auto& d) {
      return d.text == t.designation && d.isInner == t.isInner && d.low < t.high && t.low < d.high;
    });
    if (!isShown) all.diameters.push_back({t.isInner ? t.minor : t.major, t.low, t.high, t.isInner, t.designation});
  }
}

// Adds radii, angles and chamfers. Equal ones share a note, which says how many there are.
void addNotes(const std::vector<ProfileFeature>& features, const DrawingTitle& title, PartDimensions& all) {
  std::vector<std::pair<PartDimensions::Note, int>> counted;
  for (const ProfileFeature& f : features) {
    if (f.kind != ProfileFeature::Kind::Arc && f.kind != ProfileFeature::Kind::Taper) continue;
    const std::string text = noteOf(f, title);
    const auto known =
        std::find_if(counted.begin(), counted.end(), [&](const auto& each) { return each.first.text == text; });
    if (known != counted.end()) {
      ++known->second;
    } else {
      counted.push_back({{middleOf(f), text}, 1});
    }
  }
  for (auto& [note, count] : counted) {
    // A chamfer, "2×45°", has a sign of its own.
    const bool isChamfered = note.text.find("×") != std::string::npos;
    if (count > 1) note.text = std::to_string(count) + (isChamfered ? "× " : "×") + note.text;
    all.notes.push_back(std::move(note));
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
    all.notes.push_back({besideMiddle(*longest), "Ra " + sizeText(rough.ra), true});
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
  // The lower end of such a length follows from the upper one.
  for (const PartDimensions::Length& span : all.spans) {
    const std::string whole =
        toleratedText(title, DrawnTolerance::Of::Length, upperEnd - span.from, span.from, upperEnd, {});
    const bool isEnd = span.from == all.outerHeights.front() || whole != sizeText(upperEnd - span.from);
    if (!isEnd) std::erase(all.outerHeights, span.from);
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
  const DrawnOutline outline(std::move(features), part.isClosed());
  PartDimensions all;
  addDiameters(outline, title, isSmoothed, all);
  addAsked(part, title, all);
  addNotes(outline.features(), title, all);
  addRoughness(outline.features(), title, all);
  addHeight(all.outerHeights, part.lowerEnd(), least);
  addHeight(all.outerHeights, part.upperEnd(), least);
  for (const double z : outline.heights(false)) addHeight(all.outerHeights, z, least);
  std::vector<double> inner;
  for (const double z : outline.heights(true)) addHeight(inner, z, least);
  // A height that the outside has needs no second dimension.
  for (const double z : inner) {
    const bool isOutside = std::any_of(all.outerHeights.begin(), all.outerHeights.end(),
                                       [&](double known) { return std::abs(z - known) < std::max(kSameSize, least); });
    if (!isOutside) all.innerHeights.push_back(z);
  }
  for (auto* heights : {&all.outerHeights, &all.innerHeights}) std::sort(heights->begin(), heights->end());
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
