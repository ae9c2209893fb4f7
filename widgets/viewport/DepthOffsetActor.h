// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/LayerFrame.h"
#include "viewport/LayerProps.h"
#include "viewport/surface/PolyData.h"

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <span>

namespace handwheel {

// Sets a VTK clipping plane. VTK keeps the half-space into which the normal points.
void setPlane(vtkPlane* plane, const Vec3& normal, const Vec3& point);

// Sets the material of actors over the model, which are hardly shaded.
void setOverlayMaterial(vtkProperty* property);

// An actor over the model, coloured by point data. It is offset towards the viewer by the length of some pixels, which
// changes only its depth.
class DepthOffsetActor {
 public:
  // lift: logical pixels towards the viewer; an actor with a larger lift hides one with a smaller lift.
  DepthOffsetActor(LayerProps& props, double lift);

  void setData(vtkPolyData* data);
  // Makes the actor visible in front of everything. Among such actors, the one with the largest lift is in front.
  // To be called before the first frame with the actor.
  void drawOverAll();
  void hide() { m_props.show(m_actor, false); }
  void prepare(const LayerFrame& frame);
  vtkActor* actor() { return m_actor; }
  vtkProperty* property() { return m_actor->GetProperty(); }

 private:
  void clip(const ClipPlane& plane, const Vec3& shift, double scale);

  LayerProps& m_props;
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
class StrokeActors {
 public:
  // width: logical pixels.
  StrokeActors(LayerProps& props, double lift, double width);

  void set(const std::vector<Stroke>& strokes, const Vec3& origin);
  void drawOverAll();  // see DepthOffsetActor
  void hide();
  void prepare(const LayerFrame& frame);

 private:
  DepthOffsetActor m_segments;
  DepthOffsetActor m_dots;
  double m_width;
};

}  // namespace handwheel
