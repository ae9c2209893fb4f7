// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/BodyGeometry.h"

namespace handwheel {

BodyGeometry::~BodyGeometry() = default;

void BodyGeometry::makeOnce() const {
  std::call_once(m_made, [this] {
    auto surface = makeSurface();
    for (const Vec3& p : surface->points) m_bounds.extend(p);
    m_surface = std::move(surface);
  });
}

const std::shared_ptr<const TriangleSoup>& BodyGeometry::surface() const {
  makeOnce();
  return m_surface;
}

const Box& BodyGeometry::bounds() const {
  makeOnce();
  return m_bounds;
}

}  // namespace handwheel
