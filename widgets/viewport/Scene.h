// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ClipPlane.h"
#include "viewport/Marks.h"
#include "viewport/camera/CameraNavigation.h"
#include "viewport/surface/MeshBlocks.h"
#include "viewport/surface/PartActors.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace handwheel {

// A renderer with a mesh, rigid parts, marks, lights and background. Used by the viewport widget, and for pictures
// without a widget.
class Scene {
 public:
  Scene();

  vtkRenderer* renderer() { return m_renderer; }
  MeshBlocks& blocks() { return m_blocks; }
  Marks& marks() { return m_marks; }
  const std::vector<LoopMark>& loops() const { return m_marks.loops(); }

  // Removes mesh, parts and marks.
  void clear();
  // Sets another mesh with the bounds of its live faces; its blocks must be enqueued relative to origin(). Keeps the
  // marks.
  void setMesh(const HalfEdgeMesh& mesh, const Box& bounds);
  // The same mesh after an edit; the origin stays.
  void updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched);
  const HalfEdgeMesh& mesh() const { return m_mesh; }
  const Box& meshBounds() const { return m_meshBounds; }
  // Sets the bounds of a mesh shown in place of the mesh, so that the near and far planes do not clip it.
  void setLiveBounds(const Box& bounds) { m_liveBounds = bounds; }

  // The parts of the model, and those that a tool proposes, which are translucent.
  PartActors& parts() { return m_parts; }
  PartActors& proposedParts() { return m_proposed; }
  const PartActors& parts() const { return m_parts; }
  void setParts(const std::vector<DisplayPart>& parts);

  Box bounds() const;  // of mesh and parts
  const Vec3& origin() const { return m_origin; }
  // Some thousand points of mesh and parts, enough to estimate their extent in any direction.
  std::vector<Vec3> outline() const;

  void setShading(Shading shading);
  void setDark(bool dark);
  void setClipPlane(const ClipPlane& plane);
  const ClipPlane& clipPlane() const { return m_clip; }
  const SceneColours& colours() const { return m_style.colours; }
  // Takes geometry from the queues, as much as the next frame may upload. Returns false when nothing was waiting.
  bool takeGeometry();
  // The same for the selected or highlighted faces, which are drawn in the next frame. Returns true when some are left.
  bool takeFaces();
  // How often a block of the mesh or of a part has been built.
  int builtCount() const;
  // Sets camera and line widths for the next frame. size in logical pixels.
  void prepare(const CameraState& camera, const Vec2& size, double pixelRatio);

 private:
  void setOrigin(const Vec3& origin);
  void applyStyle();
  void placeClipPlane();
  void placeCamera(const CameraNavigation& view);

  vtkNew<vtkRenderer> m_renderer;
  MeshBlocks m_blocks;
  PartActors m_parts;
  PartActors m_proposed;
  Marks m_marks;
  SurfaceStyle m_style;
  ClipPlane m_clip;
  vtkNew<vtkPlane> m_clipPlane;  // the same, about the origin
  HalfEdgeMesh m_mesh;
  Box m_meshBounds;
  Box m_liveBounds;
  std::vector<Vec3> m_meshOutline;
  Vec3 m_origin = Vec3::Zero();
};

}  // namespace handwheel
