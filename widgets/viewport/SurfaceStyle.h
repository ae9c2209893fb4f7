// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/Lighting.h"
#include "viewport/ViewportTypes.h"

#include <vtkPlane.h>
#include <vtkSmartPointer.h>

class vtkActor;

namespace handwheel {

// How the surfaces of the scene are drawn, mesh and parts alike.
struct SurfaceStyle {
  Shading shading = Shading::Shaded;
  SceneColours colours;
  double pixelRatio = 1.0;         // device pixels to a logical pixel
  vtkSmartPointer<vtkPlane> clip;  // about the origin of the drawing; null for none
};

// What one surface has of its own.
struct SurfaceMaterial {
  QColor front;
  bool smooth = true;  // shade by the normals of the points, else by those of the faces
  double opacity = 1.0;
  bool glossy = true;  // else without highlights, which would whiten colours that mean something
};

// Under a clipping plane the inner sides are flat in one colour, so that a solid looks cut through.
void applyStyle(vtkActor* actor, const SurfaceStyle& style, const SurfaceMaterial& material);

// VTK colours both sides of what has scalars. With keep, the inner one is as applyStyle() last made it.
void keepInnerSide(vtkActor* actor, bool keep);

}  // namespace handwheel
