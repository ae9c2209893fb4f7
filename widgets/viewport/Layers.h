// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ClipPlane.h"
#include "viewport/surface/PolyData.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <span>

namespace handwheel {

// Sets a VTK clipping plane. VTK keeps what lies on the side of its normal.
void setPlane(vtkPlane* plane, const Vec3& normal, const Vec3& point);

// The frame parameters for the layers drawn over the model. Positions are relative to the origin of the drawing.
struct LayerFrame {
  double pixelRatio = 1.0;  // device pixels to a logical pixel
  // The depth offset of a layer by a logical pixel towards the viewer, without changing its position on the screen.
  // Under parallel projection it is a shift along the view; under perspective, where a pixel is longer at larger
  // distances, a scaling towards the eye.
  Vec3 shiftPerPixel = Vec3::Zero();
  double shrinkPerPixel = 0.0;
  ClipPlane clip;
};

// Sets the material of layers over the model: hardly shaded.
void setOverlayMaterial(vtkProperty* property);

// An actor over the model, coloured by point data. It is offset towards the viewer by the length of some pixels, which
// changes only its depth.
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

// A line through points, or a dot for a single point.
struct Stroke {
  std::span<const Vec3> points;
  bool closed = false;
  QColor colour;
};

// Unlit lines of constant screen width with round joints and ends.
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
