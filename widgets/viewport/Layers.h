// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ClipPlane.h"
#include "viewport/PolyData.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <span>

namespace handwheel {

// The plane as VTK has it, which keeps what lies on the side of its normal.
void setPlane(vtkPlane* plane, const Vec3& normal, const Vec3& point);

// What the layers over the model need to know of a frame. Positions are about the origin of the drawing.
struct LayerFrame {
  double pixelRatio = 1.0;  // device pixels to a logical pixel
  // What lifts a layer by a logical pixel towards the viewer and leaves it where it appears: under parallel projection
  // a shift along the view; under perspective, where a pixel is worth more the farther one looks, a shrinking towards
  // the eye.
  Vec3 shiftPerPixel = Vec3::Zero();
  double shrinkPerPixel = 0.0;
  ClipPlane clip;
};

// Of what lies over the model: hardly shaded.
void setOverlayMaterial(vtkProperty* property);

// One actor over the model, coloured by its points. It is lifted by some pixels' worth of length towards the viewer,
// which changes nothing but its depth.
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
  void clip(const ClipPlane& plane, const Vec3& shift, double scale);

  vtkNew<vtkActor> m_actor;
  vtkNew<vtkPolyDataMapper> m_mapper;
  vtkNew<vtkPlane> m_plane;
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
