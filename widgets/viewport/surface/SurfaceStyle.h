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
  vtkSmartPointer<vtkPlane> clip;  // relative to the origin of the drawing; null for none
};

// The material of one surface.
struct SurfaceMaterial {
  QColor front;
  bool smooth = true;  // shade by point normals, else by face normals
  double opacity = 1.0;
  double gloss = 0.12;   // strength of highlights, 0…1; 0 if they would whiten colours that carry data
  bool isSolid = false;  // closed, so that under a clipping plane its back side is the section, which is hatched
};

// Applies style and material to an actor. Under a clipping plane the back sides have one flat colour, so that a solid
// looks cut through: where a ray comes in through the plane, the first back side stands for the section.
void applyStyle(vtkActor* actor, const SurfaceStyle& style, const SurfaceMaterial& material);

// Keeps the back side of a surface with scalars in its own colour. VTK colours both sides of it; with keep, the back
// side stays as applyStyle() set it.
void keepInnerSide(vtkActor* actor, bool keep);

}  // namespace handwheel
