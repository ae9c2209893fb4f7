// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Picking.h"
#include "viewport/surface/SurfaceStyle.h"

#include <vtkNew.h>
#include <vtkRenderer.h>

namespace handwheel {

// A renderer with layers, lights and background. It is used by the viewport widget, and for pictures without a widget.
class Scene {
 public:
  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  vtkRenderer* renderer() { return m_renderer; }

  // Adds a layer. listener: the function that is called for changes of the layer until the layer is removed.
  void add(std::shared_ptr<ViewLayer> layer, ViewLayer::Listener listener = {});
  void remove(const ViewLayer& layer);
  // Returns the visible layers.
  Pickable pickable() const;
  bool isSearchable() const;
  // Tells the layers which of their elements is under the cursor.
  void setHovered(const Pick& pick);

  Box bounds() const;  // bounding box of the visible layers
  // Returns some thousand points of the layers, enough to estimate their extent in any direction.
  std::vector<Vec3> outline() const;

  void setShading(Shading shading);
  Shading shading() const { return m_style.shading; }
  void setDark(bool dark);
  void setClipPlane(const ClipPlane& plane);
  const ClipPlane& clipPlane() const { return m_clip; }
  const SceneColours& colours() const { return m_style.colours; }

  // Uploads waiting geometry, at most the amount allowed per frame. Returns false if no geometry was waiting.
  bool uploadPendingGeometry();
  // Uploads marks, which are drawn in the next frame. Returns true if some marks remain to be uploaded.
  bool takeMarks();
  // Waits until the workers have built all geometry, and uploads it.
  void finish();
  // Sets whether the layers are shown in simplified versions.
  void setCoarseShown(bool isReduced);
  // Returns the number of geometry builds of all present layers.
  int builtCount() const;
  // Sets camera and line widths for the next frame. size: the size of the view in logical pixels.
  void prepare(const CameraState& camera, const Vec2& size, double pixelRatio);
  // Paints the overlays of the layers, such as a legend, over the frame. size: the size of the view in logical pixels.
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
  vtkNew<vtkPlane> m_clipPlane;  // the clipping plane relative to m_origin
  Vec3 m_origin = Vec3::Zero();  // the model point at the origin of the drawing
  bool m_isPlaced = false;       // m_origin has been set near the model
};

}  // namespace handwheel
