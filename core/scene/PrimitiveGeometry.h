// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "scene/BodyGeometry.h"

#include <span>
#include <vector>

namespace handwheel {

// The primitive shapes. They are centred at the origin. The axis of round shapes is z, and the apex of a cone is at the
// top.
enum class Primitive { Cuboid, Cylinder, Sphere, Cone };

// The names of a primitive and of its dimensions, in order.
struct PrimitiveDescription {
  struct Dimension {
    const char* id;     // Name in files and on the command line: "size_x"
    const char* label;  // English text, translated in the context "Property": "Size X"
  };
  Primitive primitive;
  const char* id;     // Name in files and on the command line: "box"
  const char* label;  // English text, translated in the context "Property": "Box"
  std::vector<Dimension> dimensions;
};

// Returns all primitives, in the order of their enumeration.
std::span<const PrimitiveDescription> primitives();

// The shape of a body that is defined by a few dimensions. Round shapes are displayed with 48 sides.
class PrimitiveGeometry : public BodyGeometry {
 public:
  static constexpr std::string_view kKind = "primitive";
  static constexpr double kLeastSize = 1e-6, kLargestSize = 1e6;  // mm; limits of each dimension

  // Makes a shape. dimensions: mm, in the order of PrimitiveDescription. Errors: CountMismatch {"dimensions", wanted,
  // given}, ValueOutOfRange {dimension, value, least, largest}.
  static Result<std::shared_ptr<const PrimitiveGeometry>> make(Primitive primitive, std::vector<double> dimensions);

  const PrimitiveDescription& description() const { return primitives()[static_cast<std::size_t>(m_primitive)]; }
  Primitive primitive() const { return m_primitive; }
  const std::vector<double>& dimensions() const { return m_dimensions; }  // mm

  std::string_view kind() const override { return kKind; }
  std::size_t bytes() const override { return sizeof *this + m_dimensions.size() * sizeof(double); }

 protected:
  std::shared_ptr<const TriangleSoup> makeSurface() const override;

 private:
  PrimitiveGeometry(Primitive primitive, std::vector<double> dimensions)
      : m_primitive(primitive), m_dimensions(std::move(dimensions)) {}

  Primitive m_primitive;
  std::vector<double> m_dimensions;
};

}  // namespace handwheel
