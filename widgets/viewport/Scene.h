// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraNavigation.h"
#include "viewport/Marks.h"
#include "viewport/MeshBlocks.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace handwheel {

// One renderer with the model, the marks on it, lights and background; used by the widget and for pictures without one.
class Scene {
 public:
  Scene();

  vtkRenderer* renderer() { return m_renderer; }
  MeshBlocks& blocks() { return m_blocks; }
  Marks& marks() { return m_marks; }
  const std::vector<LoopMark>& loops() const { return m_marks.loops(); }

  void clear();
  // Another model with the bounds of its live faces; its blocks are to be enqueued about origin(). Keeps the marks.
  void setMesh(const HalfEdgeMesh& mesh, const Box& bounds);
  // The same model after an edit; the origin stays.
  void updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched);
  const HalfEdgeMesh& mesh() const { return m_mesh; }
  const Box& bounds() const { return m_bounds; }
  const Vec3& origin() const { return m_origin; }
  // A few thousand points of the model, enough to tell how far it reaches in any direction.
  const std::vector<Vec3>& outline() const { return m_outline; }

  void setDark(bool dark);
  const SceneColours& colours() const { return m_colours; }
  // Sets camera and line widths for the next frame. size in logical pixels.
  void prepare(const CameraState& camera, const Vec2& size, double pixelRatio);

 private:
  void placeCamera(const CameraState& camera);

  vtkNew<vtkRenderer> m_renderer;
  MeshBlocks m_blocks;
  Marks m_marks;
  SceneColours m_colours;
  HalfEdgeMesh m_mesh;
  Box m_bounds;
  std::vector<Vec3> m_outline;
  Vec3 m_origin = Vec3::Zero();
};

}  // namespace handwheel
