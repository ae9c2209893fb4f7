// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/drawing/DrawingScale.h"

#include "base/NumberText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace handwheel {

namespace {

using Align = Sheet::Align;

constexpr std::array kScales{50.0, 20.0, 10.0, 5.0,  2.0,  1.0,  0.5,  0.2,  0.1,
                             0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4};

// Returns as much of a text as fits, cut between characters.
std::string fitted(const std::string& text, double height, double room) {
  if (widthOf(text, height) <= room) return text;
  std::string cut = text;
  while (!cut.empty() && widthOf(cut, height) > room - 2.0 * height) {
    while (!cut.empty() && (static_cast<unsigned char>(cut.back()) & 0xc0) == 0x80) cut.pop_back();
    if (!cut.empty()) cut.pop_back();
  }
  return cut + "…";
}

// Returns a text in two lines that are no longer than the room, split at a blank if there is one.
std::pair<std::string, std::string> twoLines(const std::string& text, double height, double room) {
  std::size_t split = std::string::npos;
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1))
    if (widthOf(text.substr(0, at), height) <= room) split = at;
  if (split == std::string::npos) return {fitted(text, height, room), {}};
  return {text.substr(0, split), fitted(text.substr(split + 1), height, room)};
}

void rectangle(Sheet& sheet, const ProfilePoint& low, const ProfilePoint& high, Sheet::Line kind) {
  const ProfilePoint a(high.x(), low.y()), b(low.x(), high.y());
  sheet.line(low, a, kind);
  sheet.line(a, high, kind);
  sheet.line(high, b, kind);
  sheet.line(b, low, kind);
}

void circle(Sheet& sheet, const ProfilePoint& centre, double radius) {
  sheet.strokes.push_back({arcAround(centre, radius, 0.0, M_PI), Sheet::Line::Narrow});
  sheet.strokes.push_back({arcAround(centre, radius, M_PI, 2.0 * M_PI), Sheet::Line::Narrow});
}

// Draws a frustum from the side, its small end at the left, and its view from there at the right.
void addFirstAngleSign(Sheet& sheet, const ProfilePoint& centre) {
  const double small = 1.5, large = 3.0, half = 3.0;
  const ProfilePoint side = centre - ProfilePoint(5.5, 0), front = centre + ProfilePoint(4.5, 0);
  sheet.line(side + ProfilePoint(-half, -small), side + ProfilePoint(-half, small));
  sheet.line(side + ProfilePoint(half, -large), side + ProfilePoint(half, large));
  sheet.line(side + ProfilePoint(-half, small), side + ProfilePoint(half, large));
  sheet.line(side + ProfilePoint(-half, -small), side + ProfilePoint(half, -large));
  circle(sheet, front, small);
  circle(sheet, front, large);
  sheet.line(side - ProfilePoint(half + 1.5, 0), side + ProfilePoint(half + 1.5, 0), Sheet::Line::Centre);
  sheet.line(front - ProfilePoint(4.5, 0), front + ProfilePoint(4.5, 0), Sheet::Line::Centre);
  sheet.line(front - ProfilePoint(0, 4.5), front + ProfilePoint(0, 4.5), Sheet::Line::Centre);
}

}  // namespace

double standardScale(double length, double room) {
  for (const double scale : kScales)
    if (scale * length <= room) return scale;
  return kScales.back();
}

double nextScale(double scale) {
  const auto next = std::find_if(kScales.begin(), kScales.end(), [&](double other) { return other < scale; });
  return next == kScales.end() ? kScales.back() : *next;
}

std::string scaleText(double scale) {
  return scale >= 1.0 ? roundedText(scale) + ":1" : "1:" + roundedText(1.0 / scale);
}

std::string sizeText(double value) {
  constexpr double kNoise = 1e-6;  // hundredths of a mm: 1.425 may be stored as 1.42499…, and is rounded up
  return roundedText(std::round(value * 100.0 + std::copysign(kNoise, value)) / 100.0, 12);
}

void addTitleBlock(Sheet& sheet, const std::string& name, const std::string& material, double scale) {
  const ProfilePoint low(kFrameLeft, kFrame), high(sheet.width - kFrame, sheet.height - kFrame);
  rectangle(sheet, low, high, Sheet::Line::Wide);
  const double left = high.x() - kTitleWidth, bottom = low.y(), middle = bottom + 0.5 * kTitleHeight;
  rectangle(sheet, {left, bottom}, {high.x(), bottom + kTitleHeight}, Sheet::Line::Wide);
  const std::array columns{left + 80.0, left + 105.0, left + 130.0, left + 145.0};
  sheet.line({left, middle}, {columns[3], middle});
  for (const double x : columns) sheet.line({x, bottom}, {x, bottom + kTitleHeight});

  constexpr double kSmaller = 3.5, kSmallest = 2.5;  // mm, heights of texts that are too long
  const auto field = [&](double x, double y, const char* label, const std::string& value, double room, double size) {
    sheet.text({x + 1.5, y + 8.8}, label, Align::Left, 1.8);
    const double width = room - 3.0;
    for (const double height : {size, std::min(size, kSmaller), kSmallest})
      if (widthOf(value, height) <= width) return sheet.text({x + 1.5, y + 2.5}, value, Align::Left, height);
    const auto [first, second] = twoLines(value, kSmallest, width);
    sheet.text({x + 1.5, y + 4.9}, first, Align::Left, kSmallest);
    if (!second.empty()) sheet.text({x + 1.5, y + 1.3}, second, Align::Left, kSmallest);
  };
  field(left, middle, "Name", name, 80.0, 5.0);
  field(left, bottom, "Material", material, 80.0, 3.5);
  field(columns[0], middle, "Scale", scaleText(scale), 25.0, 3.5);
  field(columns[0], bottom, "Unit", "mm", 25.0, 3.5);
  field(columns[1], middle, "Sheet", sheet.width > 300.0 ? "A3" : "A4", 25.0, 3.5);
  field(columns[1], bottom, "Program", "Handwheel", 25.0, 2.5);
  field(columns[2], middle, "No.", "1/1", 15.0, 3.5);
  addFirstAngleSign(sheet, {columns[3] + 12.5, middle});
}

}  // namespace handwheel
