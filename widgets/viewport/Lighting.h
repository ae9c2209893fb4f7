// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class vtkRenderer;

namespace handwheel {

// The colours of the scene outside the marks.
struct SceneColours {
  QColor backgroundTop;
  QColor backgroundBottom;
  QColor front;     // the material
  QColor back;      // the inner side, seen through holes
  QColor cut;       // the inner side, when a clipping plane opens the model
  QColor edge;      // over the material
  QColor wire;      // before the background
  QColor casing;    // thin rim around lines and dots that sets them off the surface
  QColor text;      // scale bar and axis letters
  QColor accent;    // preview and hover
  QColor cubeSide;  // of the view cube
  QColor selected;  // faces that are selected
};
SceneColours sceneColours(bool dark);

// share: of b, 0…1.
QColor mixed(const QColor& a, const QColor& b, float share);

// Three lights that turn with the camera, as in a photographer's studio: key from the upper left, fill from the right,
// head light from the viewer. Scans read by their relief, wherever one looks from.
void addStudioLights(vtkRenderer* renderer);

}  // namespace handwheel
