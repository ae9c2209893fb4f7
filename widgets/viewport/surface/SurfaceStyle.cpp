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

const std::string kColourTag = "//VTK::Color::Impl";

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

// Hatches the flat back side at 45° on the screen, as drawings have sections, also where the front has colours for each
// point. The names are those of vtkOpenGLPolyDataMapper.
void hatchInnerSide(vtkActor* actor, double pixelRatio) {
  constexpr double kPeriod = 9.0, kLine = 1.6, kShade = 0.62;  // logical pixels along a row; factor of the colour
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << kColourTag << "\n  if (gl_FrontFacing == false) {\n    ambientColor = "
       << shaderColour(actor->GetBackfaceProperty()->GetAmbientColor(), 1.0)
       << ";\n    diffuseColor = vec3(0.0);\n    if (mod(gl_FragCoord.x + gl_FragCoord.y, " << std::fixed
       << kPeriod * pixelRatio << ") < " << kLine * pixelRatio << ") ambientColor *= " << kShade << ";\n  }\n";
  actor->GetShaderProperty()->AddFragmentShaderReplacement(kColourTag, true, text.str(), false);
}

}  // namespace

// The names are those of vtkOpenGLPolyDataMapper.
void keepInnerSide(vtkActor* actor, bool keep) {
  if (!keep) return actor->GetShaderProperty()->ClearFragmentShaderReplacement(kColourTag, true);
  vtkProperty* back = actor->GetBackfaceProperty();
  const std::string inner = "\n  if (gl_FrontFacing == false) {\n    ambientColor = " +
                            shaderColour(back->GetAmbientColor(), back->GetAmbient()) +
                            ";\n    diffuseColor = " + shaderColour(back->GetDiffuseColor(), back->GetDiffuse()) +
                            ";\n  }\n";
  actor->GetShaderProperty()->AddFragmentShaderReplacement(kColourTag, true, kColourTag + inner, false);
}

void applyStyle(vtkActor* actor, const SurfaceStyle& style, const SurfaceMaterial& material) {
  vtkProperty* front = actor->GetProperty();
  setColour(front, material.front);
  setLit(front, material.gloss);
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
  if (!material.isSolid) return;
  if (style.clip && style.shading != Shading::Wireframe)
    hatchInnerSide(actor, style.pixelRatio);
  else
    actor->GetShaderProperty()->ClearFragmentShaderReplacement(kColourTag, true);
}

}  // namespace handwheel
