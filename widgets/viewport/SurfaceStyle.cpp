// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/SurfaceStyle.h"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkProperty.h>

namespace handwheel {

namespace {

void setColour(vtkProperty* property, const QColor& colour) {
  property->SetColor(colour.redF(), colour.greenF(), colour.blueF());
}

void setLit(vtkProperty* property, double specular) {
  property->SetAmbient(0.18);
  property->SetDiffuse(0.86);
  property->SetSpecular(specular);
  property->SetSpecularPower(28);
}

void setFlat(vtkProperty* property) {
  property->SetAmbient(1.0);
  property->SetDiffuse(0.0);
  property->SetSpecular(0.0);
}

void setLines(vtkProperty* property, const SurfaceStyle& style) {
  const QColor& edge = style.colours.edge;
  property->SetEdgeVisibility(style.shading == Shading::ShadedWithEdges);
  property->SetEdgeColor(edge.redF(), edge.greenF(), edge.blueF());
  property->SetLineWidth(static_cast<float>(style.pixelRatio));
  const bool isWireframe = style.shading == Shading::Wireframe;
  isWireframe ? property->SetRepresentationToWireframe() : property->SetRepresentationToSurface();
  property->SetLighting(!isWireframe);
  if (isWireframe) setColour(property, style.colours.wire);
}

void clip(vtkMapper* mapper, vtkPlane* plane) {
  const bool isClipped = mapper->GetNumberOfClippingPlanes() > 0;
  if (isClipped == (plane != nullptr)) return;
  plane ? mapper->AddClippingPlane(plane) : mapper->RemoveAllClippingPlanes();
}

}  // namespace

void applyStyle(vtkActor* actor, const SurfaceStyle& style, const SurfaceMaterial& material) {
  vtkProperty* front = actor->GetProperty();
  setColour(front, material.front);
  setLit(front, 0.12);
  front->SetOpacity(material.opacity);
  material.smooth ? front->SetInterpolationToPhong() : front->SetInterpolationToFlat();
  if (!actor->GetBackfaceProperty()) actor->SetBackfaceProperty(vtkSmartPointer<vtkProperty>::New());
  vtkProperty* back = actor->GetBackfaceProperty();
  setColour(back, style.clip ? style.colours.cut : style.colours.back);
  style.clip ? setFlat(back) : setLit(back, 0.0);
  back->SetOpacity(material.opacity);
  back->SetInterpolation(front->GetInterpolation());
  for (vtkProperty* property : {front, back}) setLines(property, style);
  clip(actor->GetMapper(), style.clip);
}

}  // namespace handwheel
