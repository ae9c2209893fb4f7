// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "DisplayTestMain.h"
#include "SheetModel.h"
#include "mesh/structure/MeshBuilder.h"

namespace handwheel {

// Returns a camera that looks down on the sheet. In a view of 600 × 500 pixels, one unit is 20 pixels long and the
// point (10, 10) is in the middle.
inline CameraState sheetFromAbove() {
  CameraState c;
  c.centre = Vec3(10, 10, 0);
  c.height = 25;
  return c;
}

inline QPointF onScreen(double x, double y) {
  return {300 + (x - 10) * 20, 250 - (y - 10) * 20};
}

}  // namespace handwheel
