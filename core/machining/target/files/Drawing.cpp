// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/files/Drawing.h"

#include "machining/target/OutlineJoining.h"
#include "machining/target/TargetErrors.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// Exchanges (x, y) and (r, z): a reflection, which reverses arcs.
ProfileSegment exchanged(const ProfileSegment& s) {
  return {{s.from.y(), s.from.x()}, {s.to.y(), s.to.x()}, -s.bulge};
}

ProfileSegment mirroredSegment(const ProfileSegment& s) {
  return {{-s.from.x(), s.from.y()}, {-s.to.x(), s.to.y()}, -s.bulge};
}

bool isAlongAxis(const ProfileSegment& s) {
  return !s.isArc() && std::abs(s.from.x()) <= kDrawingGap && std::abs(s.to.x()) <= kDrawingGap;
}

// Returns the curves beside the axis, which is r = 0.
std::vector<ProfileSegment> besideAxis(const Drawing& drawing) {
  std::vector<ProfileSegment> all;
  double side = 0.0;
  for (const ProfileSegment& drawn : drawing.curves) {
    ProfileSegment s = exchanged(drawn);
    for (ProfilePoint* p : {&s.from, &s.to}) p->x() -= drawing.axis.value_or(0.0);
    if (isAlongAxis(s)) continue;
    for (ProfilePoint* p : {&s.from, &s.to}) {
      if (std::abs(p->x()) <= kDrawingGap) p->x() = 0.0;
      side = std::abs(p->x()) > std::abs(side) ? p->x() : side;
    }
    all.push_back(s);
  }
  if (side < 0.0) std::transform(all.begin(), all.end(), all.begin(), mirroredSegment);
  return all;
}

}  // namespace

Result<TargetProfile> targetIn(const Drawing& drawing, Progress progress) {
  const std::vector<ProfileSegment> beside = besideAxis(drawing);
  if (beside.empty()) return Error{TargetError::NoProfile, {}, {}, {}};
  Result<std::vector<ProfileSegment>> outline = joinedOutline(beside, kDrawingGap, progress.part(0.0, 0.5));
  if (!outline) return outline.error();
  return TargetProfile::make(std::move(outline.value()), progress.part(0.5, 1.0));
}

Drawing drawingOf(const TargetProfile& target) {
  Drawing drawing;
  for (const ProfileSegment& s : target.segments()) drawing.curves.push_back(exchanged(s));
  drawing.axis = 0.0;
  drawing.hasUnit = true;
  return drawing;
}

}  // namespace handwheel
