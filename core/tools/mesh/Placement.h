// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "tools/mesh/MeshServices.h"

#include <array>
#include <optional>
#include <span>

namespace handwheel {

// Placement of a mesh by unit, scale, rotation and translation. The mesh is first brought to millimetres, about the
// origin; then scaled, and turned about x, y and z, in this order, all about the centre of its box; then moved.
struct Placement {
  std::array<double, 3> shift{};  // mm
  std::array<double, 3> turn{};   // radian
  double scale = 1.0;
  std::size_t unit = 0;  // that the file was written in, of kUnits

  // More than lengths are shown in.
  struct Unit {
    const char* symbol;
    double millimetres;
  };
  static constexpr Unit kUnits[] = {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}, {"um", 0.001}};

  bool operator==(const Placement&) const = default;
  // The transformation. box: bounding box of the mesh.
  Eigen::Affine3d of(const Box& box) const;
};

// A placement as the values of the operation "place", and back.
Placement placementOf(const OperationValues& values);
OperationValues valuesOf(const Placement& placement);

// Creates the change for a placement. Step: "place --unit in --scale 2 --turn 0,0,90 --move 0,0,5"
MeshChange placeChange(const Placement& placement);

// A predefined placement that is computed from the mesh. From its state when the change is made: "flat", "axes",
// "centre", "corner". The id is the step, too.
struct StandardPlace {
  const char* id;
  const char* effect;  // English, context "Tool"
  const char* text;
  const char* reason;  // why there is none
  std::optional<Pose> (*find)(const HalfEdgeMesh&, Progress);
};
std::span<const StandardPlace> standardPlaces();
MeshChange placeChange(const StandardPlace& place);

}  // namespace handwheel
