// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MeshChecks.h"
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "ToolEvents.h"
#include "mesh/structure/MeshValidator.h"
#include "tools/ToolRunner.h"
#include "tools/mesh/sculpt/SculptTool.h"

namespace handwheel::test {

inline constexpr double kDrag = 0, kSmooth = 1, kInflate = 2, kFlatten = 3;

// Returns a plate of 20 × 20 squares of 1 mm. It lies in z = 0 and faces up.
inline TriangleSoup sheet() {
  return grid(21, 21, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0.0); });
}

inline Vertex at(double x, double y) {
  static const HalfEdgeMesh mesh = meshDocument(sheet())->mesh();
  return vertexAt(mesh, Vec3(x, y, 0));
}

// Returns the 8 × 8 squares around the middle of the plate.
inline FaceSelection middle() {
  FaceSelection patch;
  for (Face x = 6; x < 14; ++x)
    for (Face y = 6; y < 14; ++y)
      for (Face k = 0; k < 2; ++k) patch.add(2 * (20 * x + y) + k);
  return patch;
}

struct SculptFixture {
  std::unique_ptr<MeshDocument> document;
  ToolRunner runner;
  const SculptTool* tool = nullptr;

  explicit SculptFixture(FaceSelection patch = {}, const TriangleSoup& soup = sheet()) : document(meshDocument(soup)) {
    start(std::move(patch));
    runner.setSetting("radius", 3.0);
  }
  void start(FaceSelection patch = {}) {
    auto made = std::make_unique<SculptTool>(*document, immediateServices(*document), std::move(patch));
    tool = made.get();
    runner.start(std::move(made), *document);
  }
  void stroke(const std::vector<Eigen::Vector2d>& path, Modifiers modifiers = {}) {
    runner.pointer(above(Kind::Press, path[0].x(), path[0].y(), modifiers));
    for (const auto& p : path) runner.pointer(above(Kind::Drag, p.x(), p.y(), modifiers));
    runner.pointer(above(Kind::Release, path.back().x(), path.back().y(), modifiers));
  }
  // Lifts a point of the plate with an input device.
  void lift(double height, double x = 10.0) {
    PointerEvent event = above(Kind::Press, x, 10.0);
    event.device = Pose(Eigen::Translation3d(x, 10.0, 0.0));
    runner.pointer(event);
    event.kind = Kind::Release;
    event.device = Pose(Eigen::Translation3d(x, 10.0, height));
    runner.pointer(event);
  }
  double height(double x = 10, double y = 10) const { return document->mesh().position(at(x, y)).z(); }
  int steps() const { return document->history()->count(); }
  std::string check() const { return validate(document->mesh()); }
};

}  // namespace handwheel::test
