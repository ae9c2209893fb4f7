// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/TriangleSoup.h"
#include "robot/RobotModel.h"

namespace handwheel {

// The surface of a shape in mm, closed and with the faces turned outwards; empty for a mesh, which is in a file. Round
// shapes are cut into 48 sides around: within 0.5 % of the radius.
TriangleSoup surfaceOf(const Shape& shape);

// The points of a mesh file, in metres, placed as a shape wants them: scaled, in mm; turned over where the scale
// mirrors.
void place(const MeshShape& shape, TriangleSoup& soup);

}  // namespace handwheel
