// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/UrdfShapes.h"

#include "robot/UrdfValues.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kMostNotes = 1000;

// Reads a length in mm: above 0, and below kLargestLength.
Result<double> readLength(const XmlElement& element, std::string_view attribute) {
  const Result<double> metres = readNumber(element, attribute, 0.0);
  if (!metres) return metres.error();
  if (*metres <= 0.0 || *metres > kLargestLength)
    return malformed(element, "its " + std::string(attribute) + " is no length");
  return *metres * kMillimetresPerMetre;
}

Result<Shape> readBox(const XmlElement& box) {
  const Result<Vec3> metres = readVector(box, "size", Vec3::Zero());
  if (!metres) return metres.error();
  if (metres->minCoeff() <= 0.0 || metres->maxCoeff() > kLargestLength)
    return malformed(box, "its size is not a length");
  return Shape(BoxShape{*metres * kMillimetresPerMetre});
}

Result<Shape> readCylinder(const XmlElement& cylinder) {
  const Result<double> radius = readLength(cylinder, "radius");
  if (!radius) return radius.error();
  const Result<double> length = readLength(cylinder, "length");
  if (!length) return length.error();
  return Shape(CylinderShape{*radius, *length});
}

Result<Shape> readSphere(const XmlElement& sphere) {
  const Result<double> radius = readLength(sphere, "radius");
  if (!radius) return radius.error();
  return Shape(SphereShape{*radius});
}

Result<ShapeColour> readColour(const XmlElement& element) {
  if (!element.attribute("rgba")) return malformed(element, "it has no rgba");
  std::array<double, 4> rgba{};
  if (const Status status = readNumbers(element, "rgba", rgba); !status) return status.error();
  const auto share = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
  return ShapeColour{share(rgba[0]), share(rgba[1]), share(rgba[2])};
}

}  // namespace

void UrdfShapes::note(Error error) {
  auto& damage = m_read.damage;
  if (damage.size() < kMostNotes)
    damage.push_back(std::move(error));
  else
    ++m_read.unlistedDamage;
}

void UrdfShapes::collectMaterials(const XmlElement& robot) {
  for (const XmlElement& element : robot.children) {
    if (element.name == "material") collectMaterial(element);
    if (element.name != "link") continue;
    for (const XmlElement& visual : element.children) {
      const XmlElement* material = visual.name == "visual" ? visual.child("material") : nullptr;
      if (material) collectMaterial(*material);
    }
  }
}

void UrdfShapes::collectMaterial(const XmlElement& material) {
  const std::string* name = material.attribute("name");
  const XmlElement* colour = material.child("color");
  if (!name || name->empty() || !colour) return;
  if (const Result<ShapeColour> value = readColour(*colour)) m_materials.try_emplace(*name, *value);
}

std::optional<ShapeColour> UrdfShapes::colourOf(const XmlElement& visual) {
  const XmlElement* material = visual.child("material");
  if (!material) return {};
  if (const XmlElement* element = material->child("color")) {
    const Result<ShapeColour> colour = readColour(*element);
    if (colour) return *colour;
    note(colour.error());
    return {};
  }
  const std::string* name = material->attribute("name");
  const auto found = name ? m_materials.find(*name) : m_materials.end();
  if (found == m_materials.end()) return {};
  return found->second;
}

void UrdfShapes::readInto(Link& link, const XmlElement& element) {
  for (const XmlElement& child : element.children) {
    if (child.name == "visual") readShape(child, link.visuals, link.unreadVisuals);
    if (child.name == "collision") readShape(child, link.collisions, link.unreadCollisions);
  }
}

void UrdfShapes::readShape(const XmlElement& element, std::vector<PlacedShape>& shapes,
                           std::vector<std::string>& unread) {
  const Result<Pose> origin = readOrigin(element);
  const Result<Shape> shape = readGeometry(element);
  if (!origin || !shape) {
    const XmlElement* const geometry = element.child("geometry");
    unread.push_back(geometry && !geometry->children.empty() ? geometry->children.front().name : std::string());
    return note(origin ? shape.error() : origin.error());
  }
  shapes.push_back({numberOf(*shape), *origin, element.name == "visual" ? colourOf(element) : std::nullopt});
}

Result<Shape> UrdfShapes::readGeometry(const XmlElement& element) const {
  const XmlElement* geometry = element.child("geometry");
  if (!geometry || geometry->children.empty()) return malformed(element, "it has no shape");
  const XmlElement& shape = geometry->children.front();
  if (shape.name == "mesh") return readMesh(shape);
  if (shape.name == "box") return readBox(shape);
  if (shape.name == "cylinder") return readCylinder(shape);
  if (shape.name == "sphere") return readSphere(shape);
  return Error{ErrorCode::Unsupported, {"the shape '" + shape.name + "'"}, InputPosition::line(shape.line), {}};
}

Result<Shape> UrdfShapes::readMesh(const XmlElement& mesh) const {
  const std::string* file = mesh.attribute("filename");
  if (!file || file->empty()) return malformed(mesh, "it names no file");
  const Result<Vec3> scale = readVector(mesh, "scale", Vec3::Ones());
  if (!scale) return scale.error();
  if ((scale->array() == 0.0).any() || scale->cwiseAbs().maxCoeff() > kLargestLength)
    return malformed(mesh, "its scale is degenerate");
  return Shape(MeshShape{*file, *scale});
}

std::uint32_t UrdfShapes::numberOf(const Shape& shape) {
  auto& shapes = m_read.robot.shapes;
  const auto next = static_cast<std::uint32_t>(shapes.size());
  if (const auto* mesh = std::get_if<MeshShape>(&shape)) {
    const Vec3& s = mesh->scale;
    const auto [known, isNew] = m_meshes.try_emplace({mesh->file, {s.x(), s.y(), s.z()}}, next);
    if (!isNew) return known->second;
  }
  shapes.push_back(shape);
  return next;
}

}  // namespace handwheel
