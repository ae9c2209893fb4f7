// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/PrimitiveGeometry.h"

#include "base/NumberText.h"
#include "base/Translatable.h"
#include "nurbs/Tessellation.h"
#include "robot/ShapeSurfaces.h"

#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace handwheel {

namespace {

// With as many sides as the other round shapes.
TriangleSoup coneSurface(double radius, double length) {
  const auto profile = ProfileCurve::polyline({{radius, -0.5 * length}, {0.0, 0.5 * length}});
  assert(profile);
  TessellationOptions options;
  options.chord = radius * (1.0 - std::cos(std::numbers::pi / kShapeSides));
  options.aspect = std::numeric_limits<double>::max();  // one triangle from the base to the tip, however slender
  Result<TriangleSoup> soup = tessellate(*profile, options);
  assert(soup);
  return std::move(soup).value();
}

}  // namespace

std::span<const PrimitiveDescription> primitives() {
  static const PrimitiveDescription::Dimension kRadius{"radius", translatable("Property", "Radius")},
      kLength{"length", translatable("Property", "Length")};
  static const PrimitiveDescription kAll[] = {
      {Primitive::Cuboid,
       "box",
       translatable("Property", "Box"),
       {{"size_x", translatable("Property", "Size X")},
        {"size_y", translatable("Property", "Size Y")},
        {"size_z", translatable("Property", "Size Z")}}},
      {Primitive::Cylinder, "cylinder", translatable("Property", "Cylinder"), {kRadius, kLength}},
      {Primitive::Sphere, "sphere", translatable("Property", "Sphere"), {kRadius}},
      {Primitive::Cone, "cone", translatable("Property", "Cone"), {kRadius, kLength}},
  };
  return kAll;
}

Result<std::shared_ptr<const PrimitiveGeometry>> PrimitiveGeometry::make(Primitive primitive,
                                                                         std::vector<double> dimensions) {
  const auto& described = primitives()[static_cast<std::size_t>(primitive)].dimensions;
  if (dimensions.size() != described.size()) {
    return Error{ErrorCode::CountMismatch,
                 {"dimensions", std::to_string(described.size()), std::to_string(dimensions.size())},
                 {},
                 {}};
  }
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    if (dimensions[i] >= kLeastSize && dimensions[i] <= kLargestSize) continue;
    return Error{ErrorCode::ValueOutOfRange,
                 {described[i].id, roundedText(dimensions[i]), roundedText(kLeastSize), roundedText(kLargestSize)},
                 {},
                 {}};
  }
  return std::shared_ptr<const PrimitiveGeometry>(new PrimitiveGeometry(primitive, std::move(dimensions)));
}

std::shared_ptr<const TriangleSoup> PrimitiveGeometry::makeSurface() const {
  const auto make = [this]() -> TriangleSoup {
    const auto& size = m_dimensions;
    switch (m_primitive) {
      case Primitive::Cuboid:
        return surfaceOf(BoxShape{{size[0], size[1], size[2]}});
      case Primitive::Cylinder:
        return surfaceOf(CylinderShape{size[0], size[1]});
      case Primitive::Sphere:
        return surfaceOf(SphereShape{size[0]});
      case Primitive::Cone:
        break;
    }
    return coneSurface(size[0], size[1]);
  };
  return std::make_shared<const TriangleSoup>(make());
}

}  // namespace handwheel
