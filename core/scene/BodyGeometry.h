// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"

#include <memory>
#include <mutex>
#include <string_view>

namespace handwheel {

// Base class of the shapes of bodies. A shape is immutable, in the body's own frame, and shared between bodies and
// versions. It may be used on any thread. A new kind derives from this class; a GeometryFormat
// (document/scene/GeometryBlobs.h) defines its storage.
class BodyGeometry {
 public:
  BodyGeometry() = default;
  BodyGeometry(const BodyGeometry&) = delete;
  BodyGeometry& operator=(const BodyGeometry&) = delete;
  virtual ~BodyGeometry();

  virtual std::string_view kind() const = 0;     // Name of the kind in files: "mesh"
  virtual std::size_t bytes() const = 0;         // Memory of the definition, without the surface
  virtual bool isKnown() const { return true; }  // False: only a newer version of the program can show this kind

  // Returns the surface of the shape, for view, touch and collisions; mm. It is computed once, by the first call. The
  // result is never null, but empty for a shape that has no surface.
  const std::shared_ptr<const TriangleSoup>& surface() const;
  // Returns the bounds of the surface, which are computed with it.
  const Box& bounds() const;

 protected:
  virtual std::shared_ptr<const TriangleSoup> makeSurface() const = 0;

 private:
  void makeOnce() const;

  mutable std::once_flag m_made;
  mutable std::shared_ptr<const TriangleSoup> m_surface;
  mutable Box m_bounds;
};

using GeometryPointer = std::shared_ptr<const BodyGeometry>;

}  // namespace handwheel
