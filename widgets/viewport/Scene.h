// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Picking.h"
#include "viewport/surface/SurfaceStyle.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace handwheel {

// A renderer with layers, lights and background. Used by the viewport widget, and for pictures without a widget.
class Scene {
 public:
  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  vtkRenderer* renderer() { return m_renderer; }

  // listener: called for changes of the layer until it is removed.
  void add(std::shared_ptr<ViewLayer> layer, ViewLayer::Listener listener = {});
  void remove(const ViewLayer& layer);
  // Returns the visible layers.
  Pickable pickable() const;
  bool isSearchable() const;
  // Tells the layers which of their elements is under the cursor.
  void setHovered(const Pick& pick);

  Box bounds() const;  // bounds of the visible layers
  // Returns some thousand points of the layers, enough to estimate their extent in any direction.
  std::vector<Vec3> outline() const;

  void setShading(Shading shading);
  Shading shading() const { return m_style.shading; }
  void setDark(bool dark);
  void setClipPlane(const ClipPlane& plane);
  const ClipPlane& clipPlane() const { return m_clip; }
  const SceneColours& colours() const { return m_style.colours; }

  // Uploads geometry, as much as the next frame may. Returns false if none was waiting.
  bool uploadPendingGeometry();
  // Uploads marks, which are drawn in the next frame. Returns true if some are left.
  bool takeMarks();
  // Waits until the workers have built all geometry, and uploads it.
  void finish();
  // Shows simplified layers.
  void setCoarseShown(bool isReduced);
  // Returns the number of geometry builds of all present layers.
  int builtCount() const;
  // Sets camera and line widths for the next frame. size in logical pixels.
  void prepare(const CameraState& camera, const Vec2& size, double pixelRatio);
  // Paints the overlays of the layers, such as a legend, over the frame. size in logical pixels.
  void paintOver(QPainter& painter, const QSizeF& size, LengthUnit unit) const;

 private:
  std::vector<ViewLayer*> visible() const;
  void applyStyle();
  void placeOrigin();
  void placeClipPlane();
  void placeCamera(const CameraNavigation& view);

  vtkNew<vtkRenderer> m_renderer;
  std::vector<std::shared_ptr<ViewLayer>> m_layers;
  SurfaceStyle m_style;
  ClipPlane m_clip;
  vtkNew<vtkPlane> m_clipPlane;  // the same, about the origin
  Vec3 m_origin = Vec3::Zero();  // the model point at the origin of the drawing
  bool m_isPlaced = false;       // the origin is near the model
};

}  // namespace handwheel
