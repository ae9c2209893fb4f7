// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/PartDrawing.h"

#include "machining/drawing/Dimensions.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace handwheel {

namespace {

constexpr double kFrameMargin = 5.0;  // mm, between the frame and the view
constexpr double kBeyondAxis = 5.0;   // mm, overrun of the centre line
constexpr double kSmallText = 2.5;    // mm
constexpr std::size_t kMostDimensions = 40,
                      kCrowded = 12;  // dimensions of a drawing; from kCrowded on a larger sheet is preferred
constexpr int kSmoothings = 6;        // number of attempts; then the part is taken as it is
constexpr int kDoublings = 40;        // number of doublings of the least drawn size

// Size below which features of this part have no dimension, mm.
double leastDrawn(const TargetProfile& part) {
  return std::min(kLeastDrawn, kLeastDrawnShare * std::max(part.length(), 2.0 * part.largestRadius()));
}

// A dimple on the axis, as an arc leaves whose centre is not quite there, is no bore.
bool hasBore(const TargetProfile& part) {
  const auto all = part.segments();
  return part.isClosed() || std::any_of(all.begin(), all.end(), [&](const ProfileSegment& s) {
           return s.direction(0.5).y() < -1e-6 && std::max(s.from.x(), s.to.x()) > leastDrawn(part);
         });
}

// Returns true if two neighbours meet in a visible edge.
bool isEdge(const ProfileSegment& a, const ProfileSegment& b) {
  return a.direction(1.0).dot(b.direction(0.0)) < std::cos(0.02);
}

// Circles are seen as lines across the part: those of the outside below the axis, and in a whole view also above it.
void addEdges(Sheet& sheet, const DrawingLayout& layout, const TargetProfile& part, bool isSection) {
  constexpr std::size_t kMostSegments = 200;  // with more segments the edges would blacken the view
  const auto all = part.segments();
  if (all.size() > kMostSegments) return;
  for (std::size_t i = 0; i + 1 < all.size() + (part.isClosed() ? 1 : 0); ++i) {
    const ProfileSegment &a = all[i], &b = all[(i + 1) % all.size()];
    if (!isEdge(a, b)) continue;
    const ProfilePoint corner = a.to;
    const bool isOfOuter = a.direction(0.5).y() > 1e-6 || b.direction(0.5).y() > 1e-6;
    if (isOfOuter) {
      const double top = isSection ? 0.0 : corner.x();
      sheet.line(layout.at(top, corner.y()), layout.at(-corner.x(), corner.y()), Sheet::Line::Wide);
    } else if (isSection) {
      sheet.line(layout.at(0.0, corner.y()), layout.at(corner),
                 Sheet::Line::Wide);  // edge of the bore, behind the section
    }
  }
}

// Returns true if a segment belongs to the outside, or to a flat face that reaches it.
bool isSeenFromOutside(const ProfileSegment& s, const TargetProfile& part) {
  const double rise = s.direction(0.5).y();
  if (std::abs(rise) > 1e-6) return rise > 0.0;
  const auto extent = part.extentAt(s.from.y());
  return extent && std::max(s.from.x(), s.to.x()) >= extent->outer - 1e-6;
}

// Draws the narrow line at the root of a thread and the wide lines at its ends, on both sides of the axis, or in the
// section.
void addThread(Sheet& sheet, const DrawingLayout& layout, const TargetProfile& part, const DrawnThread& thread,
               bool isSection) {
  const double root = 0.5 * (thread.isInner ? thread.major : thread.minor);
  const double crest = 0.5 * (thread.isInner ? thread.minor : thread.major);
  for (const double side : {1.0, -1.0}) {
    if (side < 0.0 && thread.isInner && isSection) continue;
    sheet.line(layout.at(side * root, thread.low), layout.at(side * root, thread.high));
    for (const double z : {thread.low, thread.high}) {
      const bool isEnd = z <= part.lowerEnd() || z >= part.upperEnd();
      if (!isEnd) sheet.line(layout.at(side * crest, z), layout.at(side * root, z), Sheet::Line::Wide);
    }
  }
}

void addView(Sheet& sheet, const DrawingLayout& layout, const TargetProfile& part, const TargetProfile& edges,
             const std::vector<DrawnThread>& threads) {
  const bool isSection = hasBore(part);
  std::vector<ProfileSegment> upper;
  for (const ProfileSegment& s : part.segments()) {
    upper.push_back(layout.at(s));
    sheet.strokes.push_back({upper.back(), Sheet::Line::Wide});
    if (!isSection || isSeenFromOutside(s, part)) sheet.strokes.push_back({layout.below(s), Sheet::Line::Wide});
  }
  if (isSection) {
    if (!part.isClosed()) upper.push_back({upper.back().to, upper.front().from, 0.0});
    sheet.areas.push_back({std::move(upper), true});
  }
  addEdges(sheet, layout, edges, isSection);
  for (const DrawnThread& thread : threads) addThread(sheet, layout, part, thread, isSection);
  sheet.line(layout.at(0.0, part.lowerEnd()) - ProfilePoint(kBeyondAxis, 0),
             layout.at(0.0, part.upperEnd()) + ProfilePoint(kBeyondAxis, 0), Sheet::Line::Centre);
}

// The part to draw and its dimensions.
struct Drawn {
  const TargetProfile& part;
  const TargetProfile& measured;  // the same without details that are too small
  const PartDimensions& dimensions;
  const DrawingTitle& title;
};

// Returns the view on paper of this size at this scale, without frame; nothing if it has no room.
std::optional<Sheet> viewOn(double width, double height, double scale, const Drawn& drawn) {
  Sheet sheet;
  sheet.width = width;
  sheet.height = height;
  DrawingLayout layout;
  layout.scale = scale;
  addView(sheet, layout, drawn.part, drawn.measured, drawn.title.threads);
  DimensionLines(sheet, layout, drawn.measured, drawn.title).add(drawn.dimensions);
  const ProfileBox box = sheet.box();
  const ProfilePoint low(kFrameLeft + kFrameMargin, kFrame + kTitleHeight + kFrameMargin);
  const ProfilePoint high(width - kFrame - kFrameMargin, height - kFrame - kFrameMargin);
  if ((box.sizes().array() > (high - low).array()).any()) return std::nullopt;
  sheet.move(0.5 * (low + high) - box.center());
  return sheet;
}

// Returns the view at the largest scale of ISO 5455 that has room.
std::optional<std::pair<Sheet, double>> largestOn(double width, double height, const Drawn& drawn) {
  const TargetProfile& part = drawn.part;
  double scale = std::min(standardScale(part.length(), width), standardScale(2.0 * part.largestRadius(), height));
  for (;;) {
    if (auto sheet = viewOn(width, height, scale, drawn)) return std::pair(std::move(*sheet), scale);
    const double next = nextScale(scale);
    if (!(next < scale)) return std::nullopt;
    scale = next;
  }
}

std::optional<Sheet> sheetOf(const Drawn& drawn, double leftOut) {
  auto best = largestOn(297.0, 210.0, drawn);
  // A larger sheet is used if the part would be too small for its dimensions.
  const bool isSmall = !best || drawn.dimensions.count() > kCrowded || best->second * drawn.part.length() < 60.0;
  if (isSmall) {
    auto large = largestOn(420.0, 297.0, drawn);
    if (large && (!best || large->second > best->second)) best = std::move(large);
  }
  if (!best) return std::nullopt;
  auto& [sheet, scale] = *best;
  addTitleBlock(sheet, drawn.title.name, drawn.title.material, scale);
  if (leftOut > 0.0)
    sheet.text({kFrameLeft + 3.0, kFrame + 3.0}, "Without features below " + sizeText(leftOut) + " mm",
               Sheet::Align::Left, kSmallText);
  return std::move(sheet);
}

// Returns true if the part has features that are too small to be drawn, but large enough to change a size.
bool hasSmall(const TargetProfile& part, double tolerance, double least) {
  constexpr double kUnseen = 0.1;  // share of the least size
  const std::vector<ProfileFeature> features = featuresOf(part, tolerance);
  return std::any_of(features.begin(), features.end(), [&](const ProfileFeature& f) {
    const double size = (f.high - f.low).norm();
    return size < least && size > kUnseen * least;
  });
}

// Calls `use` with the measured part, its dimensions, and the size of omitted details (mm; 0: none), omitting more
// until it returns true. Returns true if it did.
template <class Use>
bool tryDimensions(const TargetProfile& part, const DrawingTitle& title, Use use) {
  double least = leastDrawn(part);
  bool isWhole = !hasSmall(part, title.tolerance, least);
  for (int i = 0; i < kDoublings; ++i, least *= 2.0, isWhole = false) {
    const std::optional<TargetProfile> smooth = isWhole ? std::nullopt : withoutSmall(part, least);
    if (!isWhole && !smooth && i < kSmoothings) continue;
    const TargetProfile& measured = smooth ? *smooth : part;
    const double tolerance = smooth ? std::max(title.tolerance, 0.5 * least) : title.tolerance;
    const PartDimensions dimensions = dimensionsOf(measured, title, tolerance, least, smooth.has_value());
    if (dimensions.count() <= kMostDimensions && use(measured, dimensions, isWhole ? 0.0 : least)) return true;
  }
  return false;
}

}  // namespace

Sheet drawingSheet(const TargetProfile& part, const DrawingTitle& title) {
  std::optional<Sheet> sheet;
  const auto draw = [&](const TargetProfile& measured, const PartDimensions& dimensions, double leftOut) {
    sheet = sheetOf({part, measured, dimensions, title}, leftOut);
    return sheet.has_value();
  };
  if (tryDimensions(part, title, draw)) return std::move(*sheet);
  Sheet empty;  // for a part beyond the least scale
  addTitleBlock(empty, title.name, title.material, nextScale(0.0));
  return empty;
}

Sheet dimensionSheet(const TargetProfile& part, const DrawingTitle& title, const DrawingLayout& layout) {
  Sheet sheet;
  const double lowest = -part.largestRadius();
  sheet.line(layout.at(lowest, part.lowerEnd()), layout.at(lowest, part.upperEnd()));  // the dimensions begin below it
  tryDimensions(part, title, [&](const TargetProfile& measured, const PartDimensions& dimensions, double) {
    DimensionLines(sheet, layout, measured, title).add(dimensions);
    return true;
  });
  sheet.strokes.erase(sheet.strokes.begin());
  return sheet;
}

}  // namespace handwheel
