// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Units.h"
#include "viewport/camera/CameraNavigation.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QPainter;
class QSizeF;
class vtkRenderer;

namespace handwheel {

class LayerProps;
struct LayerFrame;
struct SceneColours;
struct SurfaceStyle;

// An element of a layer that was found by a ray or near the cursor.
struct LayerHit {
  std::uint64_t element = 0;  // its meaning is defined by the layer
  Vec3 point = Vec3::Zero();  // point on the element
  // Distance from the origin of the ray in lengths of its direction, or from the cursor in pixels.
  double distance = 0.0;
};

// A change that a layer reports to its view.
enum class LayerChange {
  Look,         // the layer is drawn differently
  Elements,     // like Look, and earlier element numbers are no longer valid
  Model,        // like Elements, and another model is shown: the next camera move is not animated
  Search,       // the search structure of the layer is ready
  OutOfMemory,  // some of the geometry will never be shown
};

// Base class of layers, which draw, bound and pick one kind of geometry. The content is set through the derived class,
// before or after the layer was added to a view. The functions from attach() on are called by the view. Geometry is
// built on workers, and uploaded piece by piece, so that no frame takes long. All calls must be made on the window
// thread. Positions are in the coordinates of the model, mm.
class ViewLayer {
 public:
  ViewLayer();
  virtual ~ViewLayer();
  ViewLayer(const ViewLayer&) = delete;
  ViewLayer& operator=(const ViewLayer&) = delete;

  // Shows or hides the layer. A hidden layer is neither drawn nor picked nor fitted, and uploads nothing; uploaded data
  // is kept.
  void setVisible(bool visible);
  bool isVisible() const { return m_isVisible; }

  using Listener = std::function<void(const ViewLayer&, LayerChange)>;
  void attach(vtkRenderer* renderer, Listener listener);
  void detach();

  // Returns the bounds for fitting and picking; the result is empty if the layer has no geometry.
  virtual Box bounds() const = 0;
  // Returns the bounds of the drawn geometry, for the near and far planes.
  virtual Box drawnBounds() const { return bounds(); }
  // Returns some thousand points of the geometry, enough to estimate its extent in any direction.
  virtual std::vector<Vec3> outline() const = 0;

  virtual void setStyle(const SurfaceStyle& style) = 0;
  // Sets whether a simplified version is shown, if there is one. The view requests it while the camera moves on a slow
  // display.
  virtual void setCoarseShown(bool isReduced) { (void)isReduced; }
  // Uploads one piece of waiting geometry. Returns its cost in triangles, at least 1, or 0 if no geometry was waiting.
  virtual std::size_t takePiece() { return 0; }
  // Uploads one piece of the marks of the geometry, such as a selection, all of which must be uploaded before a frame
  // is drawn. Returns the cost like takePiece().
  virtual std::size_t takeMarks() { return 0; }
  virtual bool owesMarks() const { return false; }
  // Waits until the workers have built all geometry, so that it can be uploaded.
  virtual void finish() {}
  // Returns the number of geometry builds since construction.
  virtual int builtCount() const { return 0; }
  // Adapts the layer to a frame. Called before each frame.
  virtual void prepare(const LayerFrame& frame) = 0;
  // Paints overlays, such as a legend, over the finished frame. size: the size of the view in logical pixels.
  virtual void paintOver(QPainter& painter, const QSizeF& size, LengthUnit unit, const SceneColours& colours) const;

  // Returns false while a search structure is being built; until then the elements concerned are not found.
  virtual bool isSearchable() const { return true; }
  // Returns the first element along a ray. The direction must have unit length.
  virtual std::optional<LayerHit> firstHit(const Vec3& origin, const Vec3& direction) const;
  // Adds elements that are some pixels from the cursor, such as lines. If no surface hides such an element, it takes
  // precedence over the hit of a ray.
  virtual void findNear(const CameraNavigation& view, const Vec2& cursor, std::vector<LayerHit>& found) const;
  // Returns the unit normal of the surface nearest to p; the result is zero if there is no surface.
  virtual Vec3 normalNear(const Vec3& p) const;
  // Sets the element under the cursor. It has no value if the cursor is not over this layer.
  virtual void setHovered(std::optional<std::uint64_t> element) { (void)element; }

 protected:
  LayerProps& props() { return *m_props; }
  void report(LayerChange change) const;

 private:
  std::unique_ptr<LayerProps> m_props;
  Listener m_listener;
  bool m_isVisible = true;
};

}  // namespace handwheel
