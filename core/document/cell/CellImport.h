// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Note.h"
#include "document/cell/RobotCellSnapshot.h"
#include "robot/ShapeSurfaces.h"
#include "robot/dh/DhTable.h"

#include <filesystem>

namespace handwheel {

// Largest absolute coordinate of a point of a surface, mm.
inline constexpr double kLargestCoordinate = 1e9;

// Result of importing a robot description.
struct ImportedCell {
  std::shared_ptr<const RobotCellSnapshot> cell;
  std::vector<Error> damage;  // Damage of the description and the meshes; the robot opens without the damaged parts
  std::size_t unlistedDamage = 0;
  std::vector<Note> notes = {};  // Pairs of links that touch at rest, and links of an unlikely size
};

// Reads a robot description, a URDF file or a Denavit-Hartenberg table, and the meshes that it names. The joints are at
// rest. shapeSides: number of sides of round shapes, as in surfaceOf(). Errors: the errors of reading the description.
Result<ImportedCell> importCell(const std::filesystem::path& path, std::uint32_t shapeSides = kShapeSides,
                                Progress progress = {});

// Returns a cell with a built-in robot.
std::shared_ptr<const RobotCellSnapshot> cellOf(const DhTable& robot, std::uint32_t shapeSides = kShapeSides);

// Returns the surface of a shape that is not a mesh, in mm and single precision. sides: number of sides of round
// shapes.
std::shared_ptr<const TriangleSoup> roundedSurface(const Shape& shape, std::uint32_t sides);

// Returns the surface of a shape at its pose, in mm. Mesh files are STL, OBJ, PLY, OFF or COLLADA, recognised by
// content, of at most 256 MiB; locateMesh() resolves their paths. damage: receives the errors of the parts that could
// not be read. Errors: the errors of the readers, ReferenceMissing, FileTooLarge, Unsupported, ValueOutOfRange; with
// the file as subject.
Result<TriangleSoup> readSurface(const Shape& shape, const std::filesystem::path& folder, std::vector<Error>& damage,
                                 Progress progress = {});

}  // namespace handwheel
