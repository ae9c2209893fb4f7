// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/SurfaceStyle.h"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <locale>
#include <sstream>
#include <string>

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

std::string shaderColour(const double* colour, double share) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "vec3(" << share * colour[0] << ", " << share * colour[1] << ", " << share * colour[2] << ")";
  return text.str();
}

}  // namespace

// The names are those of vtkOpenGLPolyDataMapper.
void keepInnerSide(vtkActor* actor, bool keep) {
  const std::string tag = "//VTK::Color::Impl";
  if (!keep) return actor->GetShaderProperty()->ClearFragmentShaderReplacement(tag, true);
  vtkProperty* back = actor->GetBackfaceProperty();
  const std::string inner = "\n  if (gl_FrontFacing == false) {\n    ambientColor = " +
                            shaderColour(back->GetAmbientColor(), back->GetAmbient()) +
                            ";\n    diffuseColor = " + shaderColour(back->GetDiffuseColor(), back->GetDiffuse()) +
                            ";\n  }\n";
  actor->GetShaderProperty()->AddFragmentShaderReplacement(tag, true, tag + inner, false);
}

void applyStyle(vtkActor* actor, const SurfaceStyle& style, const SurfaceMaterial& material) {
  vtkProperty* front = actor->GetProperty();
  setColour(front, material.front);
  setLit(front, material.glossy ? 0.12 : 0.0);
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
