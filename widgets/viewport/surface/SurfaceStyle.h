// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Lighting.h"
#include "viewport/ViewportTypes.h"

#include <vtkPlane.h>
#include <vtkSmartPointer.h>

class vtkActor;

namespace handwheel {

// The drawing style of all surfaces, mesh and parts alike.
struct SurfaceStyle {
  Shading shading = Shading::Shaded;
  SceneColours colours;
  double pixelRatio = 1.0;         // device pixels per logical pixel
  vtkSmartPointer<vtkPlane> clip;  // clipping plane relative to the origin of the drawing; null: none
};

// The material of one surface.
struct SurfaceMaterial {
  QColor front;
  bool smooth = true;  // true: shaded by point normals; false: by face normals
  double opacity = 1.0;
  double gloss = 0.12;   // strength of highlights, 0…1; use 0 if the colours show data, which highlights would whiten
  bool isSolid = false;  // the surface is closed: under a clipping plane, its back side is hatched as the section
};

// Applies style and material to an actor. Under a clipping plane the back sides have one flat colour, so that a solid
// looks cut through: a ray that enters through the plane meets a back side first, which represents the section.
void applyStyle(vtkActor* actor, const SurfaceStyle& style, const SurfaceMaterial& material);

// Keeps the back side of a surface with scalars in its own colour. VTK colours both sides of a surface with scalars.
// keep: true if the back side keeps the colour that applyStyle() has set.
void keepInnerSide(vtkActor* actor, bool keep);

}  // namespace handwheel
