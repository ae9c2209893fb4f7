// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/PartDrawing.h"

#include "machining/drawing/Dimensions.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kSide = 25.0;       // mm, left and right of the part
constexpr double kNoteRoom = 25.0;   // mm, above it
constexpr double kBeyondAxis = 5.0;  // mm, of the centre line

bool hasBore(const TargetProfile& part) {
  const auto all = part.segments();
  return part.isClosed() || std::any_of(all.begin(), all.end(), [](const ProfileSegment& s) {
           return s.direction(0.5).y() < -1e-6 && s.at(0.5).x() > 0.0;
         });
}

// Whether two neighbours meet in an edge that is seen.
bool isEdge(const ProfileSegment& a, const ProfileSegment& b) {
  return a.direction(1.0).dot(b.direction(0.0)) < std::cos(0.02);
}

// Circles are seen as lines across the part: of the outside below the axis, of a whole view also above it.
void addEdges(Sheet& sheet, const DrawingPlace& place, const TargetProfile& part, bool isSection) {
  const auto all = part.segments();
  for (std::size_t i = 0; i + 1 < all.size() + (part.isClosed() ? 1 : 0); ++i) {
    const ProfileSegment &a = all[i], &b = all[(i + 1) % all.size()];
    if (!isEdge(a, b)) continue;
    const ProfilePoint corner = a.to;
    const bool isOfOuter = a.direction(0.5).y() > 1e-6 || b.direction(0.5).y() > 1e-6;
    if (isOfOuter) {
      const double top = isSection ? 0.0 : corner.x();
      sheet.line(place.at(top, corner.y()), place.at(-corner.x(), corner.y()), Sheet::Line::Wide);
    } else if (isSection) {
      sheet.line(place.at(0.0, corner.y()), place.at(corner), Sheet::Line::Wide);  // of the bore, behind the section
    }
  }
}

// Whether a segment is of the outside, or of a flat face that reaches it.
bool isSeenFromOutside(const ProfileSegment& s, const TargetProfile& part) {
  const double rise = s.direction(0.5).y();
  if (std::abs(rise) > 1e-6) return rise > 0.0;
  const auto extent = part.extentAt(s.from.y());
  return extent && std::max(s.from.x(), s.to.x()) >= extent->outer - 1e-6;
}

void addView(Sheet& sheet, const DrawingPlace& place, const TargetProfile& part) {
  const bool isSection = hasBore(part);
  std::vector<ProfileSegment> upper;
  for (const ProfileSegment& s : part.segments()) {
    upper.push_back(place.at(s));
    sheet.strokes.push_back({upper.back(), Sheet::Line::Wide});
    if (!isSection || isSeenFromOutside(s, part)) sheet.strokes.push_back({place.below(s), Sheet::Line::Wide});
  }
  if (isSection) {
    if (!part.isClosed()) upper.push_back({upper.back().to, upper.front().from, 0.0});
    sheet.areas.push_back({std::move(upper), true});
  }
  addEdges(sheet, place, part, isSection);
  sheet.line(place.at(0.0, part.lowerEnd()) - ProfilePoint(kBeyondAxis, 0),
             place.at(0.0, part.upperEnd()) + ProfilePoint(kBeyondAxis, 0), Sheet::Line::Centre);
}

// What the view and its dimensions take of a sheet.
struct Rooms {
  double above, below;
};

Rooms roomsFor(const PartDimensions& dimensions) {
  const std::size_t inner = dimensions.innerHeights.empty() ? 0 : dimensions.innerHeights.size() + 1;
  return {kNoteRoom + DimensionLines::roomFor(inner),
          std::max(DimensionLines::roomFor(dimensions.outerHeights.size()) + 3.0, 30.0)};
}

double scaleOn(const Sheet& sheet, const TargetProfile& part, const Rooms& rooms) {
  const double wide = sheet.width - kFrameLeft - kFrame - 2.0 * kSide;
  const double high = sheet.height - 2.0 * kFrame - kTitleHeight - rooms.above - rooms.below;
  return std::min(standardScale(part.length(), wide), standardScale(2.0 * part.largestRadius(), std::max(high, 1.0)));
}

}  // namespace

Sheet drawingSheet(const TargetProfile& part, const DrawingTitle& title) {
  const PartDimensions dimensions = dimensionsOf(part, title.tolerance);
  const Rooms rooms = roomsFor(dimensions);
  Sheet sheet;
  double scale = scaleOn(sheet, part, rooms);
  // A larger sheet where the part would be too small for its dimensions.
  Sheet large;
  large.width = 420.0;
  large.height = 297.0;
  const double onLarge = scaleOn(large, part, rooms);
  const bool isCrowded = dimensions.diameters.size() + dimensions.outerHeights.size() > 12;
  if (onLarge > scale && (isCrowded || scale * part.length() < 60.0)) {
    sheet = large;
    scale = onLarge;
  }
  const double left = kFrameLeft, right = sheet.width - kFrame;
  const double bottom = kFrame + kTitleHeight + rooms.below, top = sheet.height - kFrame - rooms.above;
  DrawingPlace place;
  place.scale = scale;
  place.origin = {0.5 * (left + right) - scale * 0.5 * (part.lowerEnd() + part.upperEnd()), 0.5 * (bottom + top)};
  addView(sheet, place, part);
  DimensionLines lines(sheet, place, part, title);
  lines.addDiameters(dimensions);
  lines.addLengths(dimensions.outerHeights, false);
  if (!dimensions.innerHeights.empty()) {
    std::vector<double> inner = dimensions.innerHeights;
    inner.push_back(part.upperEnd());
    lines.addLengths(inner, true);
  }
  lines.addNotes(dimensions);
  addTitleBlock(sheet, title.name, title.material, scale);
  return sheet;
}

}  // namespace handwheel
