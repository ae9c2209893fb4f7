// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/overlay/StrokeText.h"

#include <algorithm>
#include <array>
#include <span>

namespace handwheel {

namespace {

// A point on a grid of 4 × 6 cells, x to the right, y up from the base line. A negative x lifts the pen.
struct GridPoint {
  double x, y;
};
constexpr GridPoint kLift{-1, 0};

struct Glyph {
  char16_t sign;
  double width;
  std::span<const GridPoint> points;
};

constexpr GridPoint k0[] = {{1, 0}, {0, 1.5}, {0, 4.5}, {1, 6}, {3, 6}, {4, 4.5}, {4, 1.5}, {3, 0}, {1, 0}};
constexpr GridPoint k1[] = {{0.5, 4.5}, {2.2, 6}, {2.2, 0}};
constexpr GridPoint k2[] = {{0, 4.7}, {1, 6}, {3, 6}, {4, 4.7}, {4, 3.7}, {0, 0}, {4, 0}};
constexpr GridPoint k3[] = {{0, 5.2}, {1, 6},   {3, 6},   {4, 5}, {4, 4}, {3, 3.2}, {1.5, 3.2},
                            kLift,    {3, 3.2}, {4, 2.3}, {4, 1}, {3, 0}, {0.8, 0}, {0, 0.9}};
constexpr GridPoint k4[] = {{3, 0}, {3, 6}, {0, 1.8}, {4, 1.8}};
constexpr GridPoint k5[] = {{4, 6}, {0.4, 6}, {0.2, 3.4}, {2.8, 3.6}, {4, 2.6}, {4, 1}, {3, 0}, {1, 0}, {0, 0.9}};
constexpr GridPoint k6[] = {{3.6, 6}, {1.6, 5.2}, {0, 2.6}, {0, 1},   {1, 0},  {3, 0},
                            {4, 1},   {4, 2.5},   {3, 3.5}, {1, 3.5}, {0, 2.4}};
constexpr GridPoint k7[] = {{0, 6}, {4, 6}, {1.4, 0}};
constexpr GridPoint k8[] = {{1, 3.2}, {0, 4.2}, {0, 5.1}, {1, 6}, {3, 6}, {4, 5.1}, {4, 4.2}, {3, 3.2},
                            {1, 3.2}, {0, 2.2}, {0, 0.9}, {1, 0}, {3, 0}, {4, 0.9}, {4, 2.2}, {3, 3.2}};
constexpr GridPoint k9[] = {{0.4, 0}, {2.4, 0.8}, {4, 3.4}, {4, 5},   {3, 6},  {1, 6},
                            {0, 5},   {0, 3.5},   {1, 2.5}, {3, 2.5}, {4, 3.6}};
constexpr GridPoint kPoint[] = {{0.2, 0}, {0.4, 0}};
constexpr GridPoint kComma[] = {{0.4, 0.2}, {0, -1.2}};
constexpr GridPoint kMinus[] = {{0, 2.8}, {3, 2.8}};
constexpr GridPoint kPlus[] = {{0, 2.8}, {3, 2.8}, kLift, {1.5, 1.3}, {1.5, 4.3}};
constexpr GridPoint kX[] = {{0, 0}, {4, 6}, kLift, {0, 6}, {4, 0}};
constexpr GridPoint kY[] = {{0, 6}, {2, 3}, {4, 6}, kLift, {2, 3}, {2, 0}};
constexpr GridPoint kZ[] = {{0, 6}, {4, 6}, {0, 0}, {4, 0}};
constexpr GridPoint kC[] = {{3, 3.6}, {2.2, 4}, {0.9, 4}, {0, 3}, {0, 1}, {0.9, 0}, {2.2, 0}, {3, 0.4}};
constexpr GridPoint kI[] = {{0.3, 0}, {0.3, 4}, kLift, {0.3, 5.4}, {0.3, 5.7}};
constexpr GridPoint kM[] = {{0, 0},   {0, 4}, kLift,    {0, 3},   {0.9, 4}, {1.8, 4}, {2.5, 3.2},
                            {2.5, 0}, kLift,  {2.5, 3}, {3.4, 4}, {4.3, 4}, {5, 3.2}, {5, 0}};
constexpr GridPoint kN[] = {{0, 0}, {0, 4}, kLift, {0, 3}, {0.9, 4}, {2.2, 4}, {3, 3.2}, {3, 0}};
constexpr GridPoint kMicro[] = {{0, -1.8}, {0, 4}, kLift, {0, 1}, {0.8, 0}, {2, 0}, {3, 1}, kLift, {3, 4}, {3, 0}};

constexpr Glyph kGlyphs[] = {
    {u'0', 4, k0},       {u'1', 3, k1},       {u'2', 4, k2},     {u'3', 4, k3},    {u'4', 4, k4}, {u'5', 4, k5},
    {u'6', 4, k6},       {u'7', 4, k7},       {u'8', 4, k8},     {u'9', 4, k9},    {u'X', 4, kX}, {u'Y', 4, kY},
    {u'Z', 4, kZ},       {u'c', 3, kC},       {u'i', 0.6, kI},   {u'm', 5, kM},    {u'n', 3, kN}, {u'µ', 3, kMicro},
    {u'.', 0.6, kPoint}, {u',', 0.6, kComma}, {u'-', 3, kMinus}, {u'+', 3, kPlus}, {u' ', 1, {}},
};
constexpr double kGap = 1.3;  // between signs
constexpr double kCapital = 6.0;

const Glyph& glyphOf(QChar sign) {
  const auto it =
      std::find_if(std::begin(kGlyphs), std::end(kGlyphs), [&](const Glyph& g) { return g.sign == sign.unicode(); });
  return it == std::end(kGlyphs) ? *std::prev(std::end(kGlyphs)) : *it;
}

}  // namespace

QPainterPath strokeText(const QString& text, double height) {
  const double scale = height / kCapital;
  QPainterPath path;
  double left = 0.0;
  for (const QChar sign : text) {
    const Glyph& glyph = glyphOf(sign);
    bool isDown = false;
    for (const GridPoint& p : glyph.points) {
      const QPointF at((left + p.x) * scale, -p.y * scale);
      if (p.x >= 0) isDown ? path.lineTo(at) : path.moveTo(at);
      isDown = p.x >= 0;
    }
    left += glyph.width + kGap;
  }
  return path;
}

double strokeTextWidth(const QString& text, double height) {
  double width = 0.0;
  for (const QChar sign : text) width += glyphOf(sign).width + kGap;
  return std::max(width - kGap, 0.0) * height / kCapital;
}

}  // namespace handwheel
