// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/ZeroSymbol.h"

#include "window/workpiece/TextOutlines.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr int kOfCircle = 48, kFilling = 5;
constexpr double kArrow = 3.0, kHead = 0.4, kText = 0.9, kGap = 0.35;  // share of the radius

// Returns a point of the plane that faces the operator: right is along Z, up is against y.
Vec3 facing(double right, double up, double zero) {
  return {0.0, -up, zero + right};
}

// Two quarters are filled, as on drawings of machine zeros.
void addCircle(std::vector<PathLine>& lines, double zero, double size) {
  const auto arc = [&](double radius, int from, int to) {
    PathLine& line = lines.emplace_back();
    for (int i = from; i <= to; ++i) {
      const double angle = 2.0 * M_PI * i / kOfCircle;
      line.points.push_back(facing(radius * std::cos(angle), radius * std::sin(angle), zero));
    }
  };
  arc(size, 0, kOfCircle);
  for (int k = 1; k < kFilling; ++k) {
    arc(size * k / kFilling, 0, kOfCircle / 4);
    arc(size * k / kFilling, kOfCircle / 2, 3 * kOfCircle / 4);
  }
  lines.push_back({{facing(-size, 0.0, zero), facing(size, 0.0, zero)}});
  lines.push_back({{facing(0.0, -size, zero), facing(0.0, size, zero)}});
}

// side: towards which the barbs of its head lie.
void addArrow(std::vector<PathLine>& lines, const Vec3& from, const Vec3& direction, const Vec3& side, double size) {
  const Vec3 tip = from + kArrow * size * direction, back = tip - kHead * size * direction;
  lines.push_back({{from, tip}});
  lines.push_back({{back + 0.5 * kHead * size * side, tip, back - 0.5 * kHead * size * side}});
}

// at: the beginning of the text, or its end if it is before.
struct Label {
  Vec3 at;
  double height = 0.0;
  bool isBefore = false;
};

void addText(std::vector<PathLine>& lines, const QString& text, const Label& label, bool isFromBehind) {
  const TextOutlines written = textOutlines(text, label.height);
  const TextOutlines letters = isFromBehind ? written.reversed() : written;
  const double start = label.isBefore ? -letters.width : 0.0;
  for (const std::vector<Vec2>& outline : letters.lines) {
    PathLine& line = lines.emplace_back();
    for (const Vec2& p : outline) line.points.push_back(label.at + facing(start + p.x(), p.y(), 0.0));
  }
}

}  // namespace

PathLayer::Lines zeroSymbol(double zero, double size, const QString& name, bool isFromBehind) {
  auto lines = std::make_shared<std::vector<PathLine>>();
  const Vec3 centre(0.0, 0.0, zero), alongX = Vec3::UnitX(), alongZ = Vec3::UnitZ();
  const double height = kText * size;
  addCircle(*lines, zero, size);
  addArrow(*lines, centre, alongZ, Vec3::UnitY(), size);
  addArrow(*lines, centre, alongX, alongZ, size);
  addText(*lines, QStringLiteral("Z"), {centre + (kArrow + kGap) * size * alongZ, height}, isFromBehind);
  addText(*lines, QStringLiteral("X"), {centre + (kArrow + kGap) * size * alongX, height}, isFromBehind);
  addText(*lines, name, {facing(-(1.0 + kGap) * size, -0.5 * height, zero), height, true}, isFromBehind);
  return lines;
}

}  // namespace handwheel
