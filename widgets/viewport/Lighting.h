// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class vtkRenderer;

namespace handwheel {

// The colours of the scene, except those of the marks.
struct SceneColours {
  QColor backgroundTop;
  QColor backgroundBottom;
  QColor front;     // front side of the surface
  QColor back;      // back side of the surface, visible through holes
  QColor cut;       // back side, when a clipping plane cuts the model
  QColor edge;      // edges on the surface
  QColor wire;      // lines of the wireframe, on the background
  QColor casing;    // thin outline around lines and dots, for contrast with the surface
  QColor text;      // scale bar and axis letters
  QColor accent;    // preview and hover
  QColor cubeSide;  // sides of the view cube
  QColor selected;  // faces that are selected

  bool operator==(const SceneColours&) const = default;
};
// Returns the colours for the light or dark theme.
SceneColours sceneColours(bool dark);

// Mixes two colours. share: the weight of b, 0…1.
QColor mixed(const QColor& a, const QColor& b, float share);

// Adds three lights that turn with the camera, as in studio photography. The key light comes from the upper left, the
// fill light from the right, and the head light from the viewer. They show the relief of scans from any view direction.
void addStudioLights(vtkRenderer* renderer);

}  // namespace handwheel
