// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/Sheet.h"

#include <algorithm>
#include <string_view>

namespace handwheel {

void Sheet::arrow(const ProfilePoint& tip, const ProfilePoint& towards) {
  constexpr double kLength = 3.0, kHalfWidth = 0.5;  // mm
  const ProfilePoint along = towards.normalized(), across(-along.y(), along.x());
  const ProfilePoint back = tip - kLength * along;
  const ProfilePoint left = back + kHalfWidth * across, right = back - kHalfWidth * across;
  areas.push_back({{{tip, left, 0.0}, {left, right, 0.0}, {right, tip, 0.0}}, false});
}

// The shares are relative to the height of capitals, for the widest sans serif that the program prints with, DejaVu
// Sans.
double widthOf(const std::string& text, double height) {
  double width = 0.0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool isContinued = (byte & 0xc0) == 0x80;
    if (isContinued) continue;
    const bool isNarrow = std::string_view(" .,:;'|!ijl").find(c) != std::string_view::npos;
    const bool isWide = byte >= 0x80 || std::string_view("MWmw%").find(c) != std::string_view::npos;
    width += isNarrow ? 0.5 : isWide ? 1.4 : c >= 'A' && c <= 'Z' ? 1.1 : 0.9;
  }
  return width * height;
}

ProfileBox Sheet::Text::box() const {
  constexpr double kDescent = 0.35;  // share of the height of capitals
  const double length = widthOf(text, height), before = align == Align::Left ? 0.0 : align == Align::Centre ? 0.5 : 1.0;
  const ProfilePoint along = isUpwards ? ProfilePoint(0, 1) : ProfilePoint(1, 0);
  const ProfilePoint up = isUpwards ? ProfilePoint(-1, 0) : ProfilePoint(0, 1);
  ProfileBox box;
  box.extend(ProfilePoint(at - before * length * along - kDescent * height * up));
  box.extend(ProfilePoint(at + (1.0 - before) * length * along + height * up));
  return box;
}

void Sheet::move(const ProfilePoint& by) {
  const auto shift = [&](ProfileSegment& s) {
    s.from += by;
    s.to += by;
  };
  for (Stroke& stroke : strokes) shift(stroke.curve);
  for (Area& area : areas) std::for_each(area.outline.begin(), area.outline.end(), shift);
  for (Text& each : texts) each.at += by;
}

ProfileBox Sheet::box() const {
  ProfileBox all;
  for (const Stroke& stroke : strokes) all.extend(stroke.curve.box());
  for (const Area& area : areas)
    for (const ProfileSegment& s : area.outline) all.extend(s.box());
  for (const Text& each : texts) all.extend(each.box());
  return all;
}

}  // namespace handwheel
