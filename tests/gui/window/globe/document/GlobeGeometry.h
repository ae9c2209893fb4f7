// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/scene/GeometryBlobs.h"
#include "globe/document/GlobeSurface.h"
#include "scene/BodyGeometry.h"

namespace handwheel::test {

// A shape of a body that only these tests have: points of a globe.
class GlobeGeometry : public BodyGeometry {
 public:
  static constexpr std::string_view kKind = "globe";

  explicit GlobeGeometry(GlobeSurface points) : m_points(std::move(points)) {}

  const GlobeSurface& points() const { return m_points; }
  std::string_view kind() const override { return kKind; }
  std::size_t bytes() const override { return sizeof *this + kGlobePoints * sizeof(double); }

 protected:
  // Returns an octahedron that has its corners on the globe.
  std::shared_ptr<const TriangleSoup> makeSurface() const override;

 private:
  GlobeSurface m_points;
};

// The storage format of a globe.
extern const GeometryFormat kGlobeFormat;

}  // namespace handwheel::test
