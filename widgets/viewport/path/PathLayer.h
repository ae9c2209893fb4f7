// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Lighting.h"
#include "viewport/ViewLayer.h"

#include <memory>
#include <vector>

namespace handwheel {

// A line of a tool path that is drawn in one style.
struct PathLine {
  enum class Look { Rapid, Travel, Feed, Thread, Collision, AxisX, AxisY, AxisZ, Waypoint };
  static constexpr std::size_t kLooks = 9;

  std::vector<Vec3> points;  // mm; a single point is drawn as a dot
  Look look = Look::Feed;
};

// Splits a line into dashes of a given length, with gaps of two thirds of this length. If there would be very many
// dashes, the result is a single one. Used for rapid moves.
std::vector<PathLine> dashed(const PathLine& line, double length);

// Returns the axes of a frame as lines of the given lengths (mm), each in the usual colour of its axis.
std::vector<PathLine> axisLines(const Pose& pose, const Vec3& lengths);

// Returns the colour of a look, on the background of the view.
QColor pathColour(PathLine::Look look, const SceneColours& colours);

// A view layer with a tool path and the outline of the tool. It is drawn over the model without hiding it, and is
// ignored by fitting and picking.
class PathLayer : public ViewLayer {
 public:
  using Lines = std::shared_ptr<const std::vector<PathLine>>;

  PathLayer();
  ~PathLayer() override;

  void setLines(Lines lines);  // lines: null for no lines
  // Sets the closed outlines of the tool, such as those of a nose and its holder; empty: none.
  void setTool(std::vector<std::vector<Vec3>> outlines);

  Box bounds() const override { return {}; }
  Box drawnBounds() const override;
  std::vector<Vec3> outline() const override { return {}; }
  void setStyle(const SurfaceStyle& style) override;
  std::size_t takePiece() override;
  int builtCount() const override;
  void prepare(const LayerFrame& frame) override;

 private:
  class Private;
  std::unique_ptr<Private> d;
};

}  // namespace handwheel
