// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/DepthOffsetActor.h"

#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <string>

namespace handwheel {

void setPlane(vtkPlane* plane, const Vec3& normal, const Vec3& point) {
  plane->SetNormal(-normal.x(), -normal.y(), -normal.z());
  plane->SetOrigin(point.x(), point.y(), point.z());
}

void setOverlayMaterial(vtkProperty* property) {
  property->SetAmbient(0.45);
  property->SetDiffuse(0.6);
  property->SetSpecular(0.0);
}

DepthOffsetActor::DepthOffsetActor(LayerProps& props, double lift) : m_props(props), m_lift(lift) {
  m_actor->SetMapper(m_mapper);
  m_actor->SetVisibility(false);
  m_actor->PickableOff();
  m_mapper->SetColorModeToDirectScalars();
  m_props.add(m_actor);
}

void DepthOffsetActor::setData(vtkPolyData* data) {
  m_mapper->SetInputData(data);
  m_props.show(m_actor, true);
}

void DepthOffsetActor::drawOverAll() {
  const std::string depth = std::to_string(1e-4 / (1.0 + m_lift));
  // Added last: lines as tubes have set a depth of their own by then.
  m_actor->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Coincident::Impl", true, "//VTK::Coincident::Impl\n  gl_FragDepth = " + depth + ";\n", false);
}

void DepthOffsetActor::prepare(const LayerFrame& frame) {
  if (!m_actor->GetVisibility()) return;
  const Vec3 shift = m_lift * frame.shiftPerPixel;
  const double scale = 1.0 - m_lift * frame.shrinkPerPixel;
  const Vec3 position = scale * frame.offset + shift;
  m_actor->SetPosition(position.x(), position.y(), position.z());
  m_actor->SetScale(scale);
  clip(frame.clip, shift, scale);
}

// The plane is lifted with the actor: else one that lies just behind it would be cut away.
void DepthOffsetActor::clip(const ClipPlane& plane, const Vec3& shift, double scale) {
  const bool isClipped = m_mapper->GetNumberOfClippingPlanes() > 0;
  if (isClipped != plane.on) plane.on ? m_mapper->AddClippingPlane(m_plane) : m_mapper->RemoveAllClippingPlanes();
  if (!plane.on) return;
  setPlane(m_plane, plane.normal, scale * plane.offset * plane.normal + shift);
}

StrokeActors::StrokeActors(LayerProps& props, double lift, double width)
    : m_segments(props, lift), m_dots(props, lift), m_width(width) {
  m_segments.property()->LightingOff();
  m_dots.property()->LightingOff();
  // With tubes VTK widens lines itself; core contexts refuse glLineWidth above one.
  m_segments.property()->RenderLinesAsTubesOn();
  // Round dots. VTK's own round points are spheres with depth, which would stand out of the lines that they join.
  m_dots.actor()->GetShaderProperty()->AddFragmentShaderReplacement(
      "//VTK::Color::Impl", true, "//VTK::Color::Impl\n  if (length(gl_PointCoord - vec2(0.5)) > 0.5) discard;\n",
      false);
}

void StrokeActors::set(const std::vector<Stroke>& strokes, const Vec3& origin) {
  PolyDataBuilder segments(origin), dots(origin);
  for (const Stroke& stroke : strokes) {
    const std::size_t n = stroke.points.size();
    if (n == 0) continue;
    std::int32_t previous = -1;
    const std::int32_t first = segments.addPoint(stroke.points[0], stroke.colour);
    for (std::size_t i = 0; i < n; ++i) {
      dots.addCell({dots.addPoint(stroke.points[i], stroke.colour)});
      const std::int32_t p = i == 0 ? first : segments.addPoint(stroke.points[i], stroke.colour);
      if (previous >= 0) segments.addCell({previous, p});
      previous = p;
    }
    if (stroke.closed && n > 1) segments.addCell({previous, first});
  }
  dots.isEmpty() ? m_dots.hide() : m_dots.setData(dots.build(PolyDataBuilder::Kind::Points));
  segments.isEmpty() ? m_segments.hide() : m_segments.setData(segments.build(PolyDataBuilder::Kind::Segments));
}

void StrokeActors::drawOverAll() {
  m_segments.drawOverAll();
  m_dots.drawOverAll();
}

void StrokeActors::hide() {
  m_segments.hide();
  m_dots.hide();
}

void StrokeActors::prepare(const LayerFrame& frame) {
  const auto width = static_cast<float>(m_width * frame.pixelRatio);
  m_segments.property()->SetLineWidth(width);
  m_dots.property()->SetPointSize(width);
  m_segments.prepare(frame);
  m_dots.prepare(frame);
}

}  // namespace handwheel
