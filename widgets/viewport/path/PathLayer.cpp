// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/path/PathLayer.h"

#include "viewport/DepthOffsetActor.h"
#include "viewport/surface/SurfaceStyle.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr std::size_t kBlockPoints = 10'000;
constexpr double kMostDashes = 400;  // dashes of a line

double widthOf(PathLine::Look look) {  // logical pixels
  switch (look) {
    case PathLine::Look::Rapid:
      return 1.2;
    case PathLine::Look::Travel:
    case PathLine::Look::Feed:
      return 1.8;
    case PathLine::Look::AxisX:
    case PathLine::Look::AxisY:
    case PathLine::Look::AxisZ:
      return 2.4;
    case PathLine::Look::Waypoint:
      return 6.0;
    case PathLine::Look::Thread:
    case PathLine::Look::Collision:
      break;
  }
  return 3.2;
}

}  // namespace

QColor pathColour(PathLine::Look look, const SceneColours& colours) {
  const bool isDark = colours.backgroundTop.lightness() < 128;
  switch (look) {
    case PathLine::Look::Rapid:
      return isDark ? QColor(0xf2, 0x8b, 0x82) : QColor(0xc0, 0x30, 0x28);
    case PathLine::Look::Travel:
    case PathLine::Look::Feed:
    case PathLine::Look::Waypoint:
      return isDark ? QColor(0x6c, 0xb8, 0xf0) : QColor(0x12, 0x5f, 0xa8);
    case PathLine::Look::Collision:
      return isDark ? QColor(0xff, 0x5a, 0x4d) : QColor(0xd4, 0x10, 0x10);
    case PathLine::Look::AxisX:  // the same as in the triad of the view
      return QColor(0xe0, 0x4b, 0x43);
    case PathLine::Look::AxisY:
      return QColor(0x4c, 0xa8, 0x4f);
    case PathLine::Look::AxisZ:
      return QColor(0x3f, 0x7f, 0xe0);
    case PathLine::Look::Thread:
      break;
  }
  return isDark ? QColor(0xc6, 0x9c, 0xf4) : QColor(0x7a, 0x36, 0xb8);
}

std::vector<PathLine> axisLines(const Pose& pose, const Vec3& lengths) {
  constexpr PathLine::Look kLooks[] = {PathLine::Look::AxisX, PathLine::Look::AxisY, PathLine::Look::AxisZ};
  std::vector<PathLine> lines;
  for (int axis = 0; axis < 3; ++axis)
    lines.push_back({{pose.translation(), pose * Vec3(lengths[axis] * Vec3::Unit(axis))}, kLooks[axis]});
  return lines;
}

std::vector<PathLine> dashed(const PathLine& line, double length) {
  double whole = 0.0;
  for (std::size_t i = 1; i < line.points.size(); ++i) whole += (line.points[i] - line.points[i - 1]).norm();
  const double period = length * 5.0 / 3.0;
  if (!(period > 0.0) || !(whole > length) || !(whole / period < kMostDashes)) return {line};
  std::vector<PathLine> dashes;
  double distance = 0.0;  // length to the beginning of the piece
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const Vec3 a = line.points[i - 1], along = line.points[i] - a;
    const double size = along.norm();
    for (double from = std::floor(distance / period) * period; from < distance + size; from += period) {
      const double begin = std::max(from, distance) - distance,
                   end = std::min(from + length, distance + size) - distance;
      if (end > begin) dashes.push_back({{a + along * (begin / size), a + along * (end / size)}, line.look});
    }
    distance += size;
  }
  return dashes;
}

class PathLayer::Private {
 public:
  explicit Private(LayerProps& of) : props(of), toolRim(of, 3.0, 4.5), toolCore(of, 4.0, 2.2) {
    toolRim.drawOverAll();
    toolCore.drawOverAll();
  }

  // Begins new lines. The actors are reused for them.
  void begin() {
    for (const auto& block : blocks) block->strokes.hide();
    next = shown = 0;
  }
  std::size_t buildBlock();
  void buildTool();

  struct Block {
    Block(LayerProps& of, PathLine::Look its)
        : strokes(of, its == PathLine::Look::Rapid ? 0.5 : 1.0, widthOf(its)), look(its) {
      strokes.drawOverAll();
    }
    StrokeActors strokes;
    PathLine::Look look;
  };

  LayerProps& props;
  Lines lines;
  Box box;
  Vec3 origin = Vec3::Zero();
  std::vector<std::unique_ptr<Block>> blocks;
  std::size_t next = 0;   // line that is not in a block yet
  std::size_t shown = 0;  // blocks in use
  std::vector<std::vector<Vec3>> tool;
  StrokeActors toolRim, toolCore;
  bool isToolStale = false;
  SceneColours colours;
  int built = 0;
};

// Builds a block of consecutive lines of one look.
std::size_t PathLayer::Private::buildBlock() {
  if (!lines || next >= lines->size()) return 0;
  const PathLine::Look look = (*lines)[next].look;
  const QColor colour = pathColour(look, colours);
  std::vector<Stroke> strokes;
  std::size_t points = 0;
  for (; next < lines->size() && points < kBlockPoints && (*lines)[next].look == look; ++next) {
    strokes.push_back({(*lines)[next].points, false, colour});
    points += (*lines)[next].points.size() + 1;
  }
  const auto from = blocks.begin() + static_cast<std::ptrdiff_t>(shown);
  auto unused = std::find_if(from, blocks.end(), [look](const auto& block) { return block->look == look; });
  if (unused == blocks.end()) unused = blocks.insert(unused, std::make_unique<Block>(props, look));
  (*unused)->strokes.set(strokes, origin);
  std::iter_swap(blocks.begin() + static_cast<std::ptrdiff_t>(shown), unused);
  ++shown;
  ++built;
  return points;
}

void PathLayer::Private::buildTool() {
  std::vector<Stroke> rim, core;
  for (const auto& outline : tool) {
    rim.push_back({outline, true, colours.casing});
    core.push_back({outline, true, colours.selected});
  }
  toolRim.set(rim, origin);
  toolCore.set(core, origin);
}

PathLayer::PathLayer() : d(std::make_unique<Private>(props())) {}

PathLayer::~PathLayer() = default;

void PathLayer::setLines(Lines lines) {
  if (lines == d->lines) return;
  d->lines = std::move(lines);
  d->box = {};
  if (d->lines)
    for (const PathLine& line : *d->lines)
      for (const Vec3& p : line.points) d->box.extend(p);
  d->origin = d->box.isEmpty() ? Vec3::Zero() : Vec3(d->box.center());
  d->isToolStale = true;  // it is drawn about the same origin
  d->begin();
  report(LayerChange::Look);
}

void PathLayer::setTool(std::vector<std::vector<Vec3>> outlines) {
  if (outlines == d->tool) return;
  d->tool = std::move(outlines);
  d->isToolStale = true;
  report(LayerChange::Look);
}

Box PathLayer::drawnBounds() const {
  Box box = d->box;
  for (const auto& outline : d->tool)
    for (const Vec3& p : outline) box.extend(p);
  return box;
}

void PathLayer::setStyle(const SurfaceStyle& style) {
  if (style.colours == d->colours) return;
  d->colours = style.colours;
  d->isToolStale = true;
  d->begin();
}

std::size_t PathLayer::takePiece() {
  return d->buildBlock();
}

int PathLayer::builtCount() const {
  return d->built;
}

void PathLayer::prepare(const LayerFrame& frame) {
  if (std::exchange(d->isToolStale, false)) d->buildTool();
  const LayerFrame placed = frame.about(d->origin);
  for (const auto& block : d->blocks) block->strokes.prepare(placed);
  d->toolRim.prepare(placed);
  d->toolCore.prepare(placed);
}

}  // namespace handwheel
