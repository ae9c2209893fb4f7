// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Operation.h"
#include "tools/mesh/MeshServices.h"

#include <array>
#include <optional>
#include <span>

namespace handwheel {

// The placement of a mesh by unit, scale, rotation and translation. The mesh is first converted to millimetres about
// the origin. It is then scaled, and rotated about x, y and z in this order, about the centre of its bounding box.
// Finally it is translated.
struct Placement {
  std::array<double, 3> shift{};  // mm
  std::array<double, 3> turn{};   // radian
  double scale = 1.0;
  std::size_t unit = 0;  // index in kUnits of the unit of the file

  // A unit of a file. There are more of these than units in which lengths are shown.
  struct Unit {
    const char* symbol;
    double millimetres;
  };
  static constexpr Unit kUnits[] = {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}, {"um", 0.001}};

  bool operator==(const Placement&) const = default;
  // Returns the transformation. box: bounding box of the mesh.
  Eigen::Affine3d of(const Box& box) const;
};

// Convert the values of the operation "place" to a placement, and back.
Placement placementOf(const OperationValues& values);
OperationValues valuesOf(const Placement& placement);

// Creates the change for a placement. Its script step is "place --unit in --scale 2 --turn 0,0,90 --move 0,0,5"
MeshChange placementChange(const Placement& placement);

// A predefined placement that is computed from the mesh when the change is applied. The ids are "flat", "axes",
// "centre" and "corner"; the id is also the script step.
struct StandardPlacement {
  const char* id;
  const char* effect;  // English text, translated in the context "Tool"
  const char* text;
  const char* reason;  // the reason why there is no such placement
  std::optional<Pose> (*find)(const HalfEdgeMesh&, Progress);
};
std::span<const StandardPlacement> standardPlacements();
MeshChange placementChange(const StandardPlacement& standard);

}  // namespace handwheel
