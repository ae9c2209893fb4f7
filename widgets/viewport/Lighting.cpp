// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Lighting.h"

#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace handwheel {

namespace {

// direction: that towards the light, in view axes.
void addLight(vtkRenderer* renderer, double x, double y, double z, double intensity, const QColor& colour) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPositional(false);
  light->SetPosition(x, y, z);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(intensity);
  light->SetColor(colour.redF(), colour.greenF(), colour.blueF());
  renderer->AddLight(light);
}

}  // namespace

SceneColours sceneColours(bool dark) {
  SceneColours c;
  c.backgroundTop = dark ? QColor(0x3b, 0x41, 0x4a) : QColor(0xdd, 0xe3, 0xea);
  c.backgroundBottom = dark ? QColor(0x22, 0x25, 0x2a) : QColor(0xf7, 0xf8, 0xf9);
  c.front = dark ? QColor(0xc8, 0xc4, 0xbd) : QColor(0xd2, 0xce, 0xc7);
  c.back = dark ? QColor(0x6d, 0x78, 0x93) : QColor(0x7c, 0x88, 0xa6);
  c.cut = dark ? QColor(0xb3, 0x6a, 0x4a) : QColor(0xc9, 0x82, 0x5e);
  c.edge = dark ? QColor(0x46, 0x48, 0x4d) : QColor(0x5c, 0x5c, 0x60);
  c.wire = dark ? QColor(0xa4, 0xaa, 0xb2) : QColor(0x5a, 0x62, 0x6c);
  c.casing = dark ? QColor(0x14, 0x16, 0x19) : QColor(0xff, 0xff, 0xff);
  c.text = dark ? QColor(0xdf, 0xe3, 0xe8) : QColor(0x3a, 0x40, 0x48);
  c.accent = dark ? QColor(0x4f, 0xb3, 0xd9) : QColor(0x1f, 0x8f, 0xbf);
  c.cubeSide = dark ? QColor(0x6a, 0x72, 0x7d) : QColor(0xfb, 0xfc, 0xfd);
  c.selected = dark ? QColor(0xf0, 0xa0, 0x3c) : QColor(0xe8, 0x8a, 0x1a);
  return c;
}

QColor mixed(const QColor& a, const QColor& b, float share) {
  return QColor::fromRgbF(a.redF() + (b.redF() - a.redF()) * share, a.greenF() + (b.greenF() - a.greenF()) * share,
                          a.blueF() + (b.blueF() - a.blueF()) * share);
}

void addStudioLights(vtkRenderer* renderer) {
  renderer->SetAutomaticLightCreation(false);
  renderer->SetTwoSidedLighting(true);
  addLight(renderer, -0.55, 0.75, 0.65, 0.64, QColor(0xff, 0xf8, 0xee));
  addLight(renderer, 0.8, -0.35, 0.5, 0.36, QColor(0xe6, 0xee, 0xff));
  addLight(renderer, 0.0, 0.0, 1.0, 0.38, QColor(0xff, 0xff, 0xff));
}

}  // namespace handwheel
