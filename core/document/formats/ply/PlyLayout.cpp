// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/ply/PlyLayout.h"

#include <algorithm>

namespace handwheel {

namespace {

using Role = PlyField::Role;
using Kind = PlyLayout::Kind;

bool isAnyOf(const std::string& name, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool isCoordinate(const PlyProperty& property) {
  return !property.countType && isAnyOf(property.name, {"x", "y", "z"});
}

Kind kindOf(const PlyElement& element) {
  if (element.name == "vertex") return Kind::Vertices;
  if (element.name == "face") return Kind::Faces;
  return element.name == "tristrips" ? Kind::Strips : Kind::Other;
}

// Returns the list of corners: that with the customary name, otherwise the only list of the element.
const PlyProperty* cornersOf(const PlyElement& element) {
  const auto isList = [](const PlyProperty& p) { return p.countType.has_value(); };
  const auto& all = element.properties;
  const auto named = std::find_if(all.begin(), all.end(), [&](const PlyProperty& p) {
    return isList(p) && isAnyOf(p.name, {"vertex_indices", "vertex_index"});
  });
  if (named != all.end()) return &*named;
  if (std::count_if(all.begin(), all.end(), isList) != 1) return nullptr;
  return &*std::find_if(all.begin(), all.end(), isList);
}

LostAttribute lostWithProperty(const std::string& name) {
  if (isAnyOf(name, {"nx", "ny", "nz"})) return LostAttribute::Normals;
  if (isAnyOf(name, {"red", "green", "blue", "alpha", "r", "g", "b", "a", "diffuse_red", "diffuse_green",
                     "diffuse_blue", "diffuse_alpha", "intensity"}))
    return LostAttribute::Colour;
  if (isAnyOf(name, {"s", "t", "u", "v", "texture_u", "texture_v", "texcoord", "texnumber"}))
    return LostAttribute::TextureCoordinates;
  return name == "material_index" ? LostAttribute::Materials : LostAttribute::Other;
}

LostAttribute lostWithElement(const std::string& name) {
  if (name == "edge") return LostAttribute::Lines;
  return name == "material" ? LostAttribute::Materials : LostAttribute::Other;
}

Role roleOf(const PlyProperty& property, const PlyLayout& layout, const PlyProperty* corners) {
  if (&property == corners) return Role::Corners;
  if (layout.kind != Kind::Vertices || !isCoordinate(property)) return Role::Skipped;
  return static_cast<Role>(property.name[0] - 'x');
}

}  // namespace

PlyLayout layoutOf(const PlyElement& element) {
  PlyLayout layout;
  layout.kind = kindOf(element);
  const bool hasCorners = layout.kind == Kind::Faces || layout.kind == Kind::Strips;
  const PlyProperty* corners = hasCorners ? cornersOf(element) : nullptr;
  if (hasCorners && !corners) layout.missing = "vertex_indices";
  if (layout.kind == Kind::Other) layout.lost.emplace_back(lostWithElement(element.name), element.name);
  bool found[3] = {};
  for (const PlyProperty& property : element.properties) {
    const Role role = roleOf(property, layout, corners);
    layout.fields.push_back({role, property.type, property.countType});
    if (role == Role::Skipped && layout.kind != Kind::Other)
      layout.lost.emplace_back(lostWithProperty(property.name), property.name);
    if (role <= Role::Z) found[static_cast<int>(role)] = true;
  }
  if (layout.kind == Kind::Vertices) {
    layout.rowsName = "vertices";
    for (int axis = 2; axis >= 0; --axis)
      if (!found[axis]) layout.missing = std::string(1, static_cast<char>('x' + axis));
  }
  if (layout.kind == Kind::Faces) layout.rowsName = "faces";
  if (layout.kind == Kind::Strips) layout.rowsName = "strips";
  return layout;
}

NumberType coordinateType(const PlyHeader& header) {
  for (const PlyElement& element : header.elements)
    for (const PlyProperty& property : element.properties)
      if (element.name == "vertex" && isCoordinate(property) && property.type != PlyType::Float32)
        return NumberType::Float64;
  return NumberType::Float32;
}

}  // namespace handwheel
