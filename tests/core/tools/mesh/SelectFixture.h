// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "ToolEvents.h"
#include "tools/mesh/SelectTool.h"

namespace handwheel::test {

// Returns two parallel plates of 10 × 10 squares with integer corners, facing up. The upper plate has the faces from
// number 200 on.
inline TriangleSoup plates() {
  const auto plate = [](double z) {
    return grid(11, 11, false, false, [=](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, z); });
  };
  TriangleSoup soup = plate(0.0);
  append(soup, plate(5.0));
  return soup;
}

struct SelectFixture {
  std::unique_ptr<MeshDocument> document;
  SelectTool tool;

  explicit SelectFixture(const TriangleSoup& soup, double mode = 0)
      : document(meshDocument(soup)), tool(*document, immediateServices(*document)) {
    tool.setSetting("mode", mode);
  }
  std::vector<Face> faces() const { return tool.selection().faces.faces(); }
  std::size_t count() const { return tool.selection().faces.count(); }
  void click(double x, double y, Modifiers modifiers = {}) {
    tool.pointer(above(Kind::Press, x, y, modifiers));
    tool.pointer(above(Kind::Release, x, y, modifiers));
  }
  void stroke(const std::vector<Eigen::Vector2d>& path, Modifiers modifiers = {}) {
    tool.pointer(above(Kind::Press, path[0].x(), path[0].y(), modifiers));
    for (const auto& p : path) tool.pointer(above(Kind::Drag, p.x(), p.y(), modifiers));
    tool.pointer(above(Kind::Release, path.back().x(), path.back().y(), modifiers));
  }
};

// Returns the first of the two faces of a square of the upper plate; the other face has the next number.
inline Face upper(int x, int y) {
  return static_cast<Face>(200 + 2 * (10 * x + y));
}

inline constexpr double kClick = 0, kBrush = 1, kLasso = 2, kConnected = 3, kAngle = 4;

}  // namespace handwheel::test
