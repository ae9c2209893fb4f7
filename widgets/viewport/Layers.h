// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/PolyData.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <span>

namespace handwheel {

// What the layers over the model need to know of a frame.
struct LayerFrame {
  double pixelRatio = 1.0;     // device pixels to a logical pixel
  double unitsPerPixel = 1.0;  // model units to a logical pixel
  Vec3 towardsViewer = Vec3::UnitZ();
};

// One actor over the model, coloured by its points. It is moved towards the viewer by some pixels' worth of length:
// under a parallel projection that changes nothing but its depth, and by the same amount everywhere.
class Layer {
 public:
  // lift: logical pixels towards the viewer; a higher layer hides a lower one.
  Layer(vtkRenderer* renderer, double lift);

  void setData(vtkPolyData* data);
  void hide() { m_actor->SetVisibility(false); }
  void prepare(const LayerFrame& frame);
  vtkActor* actor() { return m_actor; }
  vtkProperty* property() { return m_actor->GetProperty(); }

 private:
  vtkNew<vtkActor> m_actor;
  vtkNew<vtkPolyDataMapper> m_mapper;
  double m_lift;
};

// A line through points, or a dot where there is but one.
struct Stroke {
  std::span<const Vec3> points;
  bool closed = false;
  QColor colour;
};

// Strokes of constant width on the screen with round joints and ends, unlit.
class StrokeLayer {
 public:
  // width: logical pixels.
  StrokeLayer(vtkRenderer* renderer, double lift, double width);

  void set(const std::vector<Stroke>& strokes, const Vec3& origin);
  void prepare(const LayerFrame& frame);

 private:
  Layer m_segments;
  Layer m_dots;
  double m_width;
};

}  // namespace handwheel
