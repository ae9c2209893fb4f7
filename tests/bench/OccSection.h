// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/section/ToolSweep.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <gp_Circ.hxx>
#include <gp_Lin.hxx>
#include <gp_Pln.hxx>

// The half section of a turned part as planar faces of Open CASCADE. It is compared with TurnedSection.
namespace handwheel::bench {

class OccSection {
 public:
  OccSection(double radius, double length) {
    SectionLoop bar;
    const std::array<ProfilePoint, 4> corners{ProfilePoint(0, 0), ProfilePoint(radius, 0), ProfilePoint(radius, length),
                                              ProfilePoint(0, length)};
    for (std::size_t i = 0; i < 4; ++i) bar.push_back(SectionSegment::line(corners[i], corners[(i + 1) % 4]));
    m_shape = faceOf(bar);
  }

  void cut(const SweptShape& shape, const ProfileSegment& move) {
    for (const SectionCutter& cutter : cuttersOf(shape, move)) {
      const SectionLoop loop = cutter(0.0);
      const TopoDS_Shape tool = loop.empty() ? TopoDS_Shape() : faceOf(loop);
      if (tool.IsNull()) {
        ++m_failures;
        continue;
      }
      BRepAlgoAPI_Cut difference(m_shape, tool);
      const bool isWell = difference.IsDone() && !difference.HasErrors();
      m_failures += isWell ? 0 : 1;
      if (isWell) m_shape = difference.Shape();
    }
  }

  int failures() const { return m_failures; }
  double area() const { return properties().Mass(); }
  // By Guldin's theorem.
  double volume() const {
    const GProp_GProps all = properties();
    return 2.0 * M_PI * all.CentreOfMass().X() * all.Mass();
  }

  std::vector<SectionSegment> boundary() const {
    std::vector<SectionSegment> all;
    for (TopExp_Explorer edges(m_shape, TopAbs_EDGE); edges.More(); edges.Next()) {
      const BRepAdaptor_Curve curve(TopoDS::Edge(edges.Current()));
      const auto at = [&](double t) { return ProfilePoint(curve.Value(t).X(), curve.Value(t).Y()); };
      const ProfilePoint from = at(curve.FirstParameter()), to = at(curve.LastParameter());
      if (curve.GetType() != GeomAbs_Circle) {
        all.push_back(SectionSegment::line(from, to));
        continue;
      }
      const gp_Circ circle = curve.Circle();
      const ProfilePoint centre(circle.Location().X(), circle.Location().Y());
      all.push_back(SectionSegment::arc(centre, from, to, circle.Axis().Direction().Z() > 0.0 ? 1 : -1));
    }
    return all;
  }

 private:
  static TopoDS_Shape faceOf(const SectionLoop& loop) {
    BRepBuilderAPI_MakeWire wire;
    for (const SectionSegment& s : loop) {
      const gp_Pnt from(s.from.x(), s.from.y(), 0.0), to(s.to.x(), s.to.y(), 0.0);
      if (!s.carrier.isCircle()) {
        wire.Add(BRepBuilderAPI_MakeEdge(from, to).Edge());
        continue;
      }
      const gp_Dir up(0.0, 0.0, s.carrier.radius > 0.0 ? 1.0 : -1.0);
      const gp_Circ circle(gp_Ax2(gp_Pnt(s.carrier.point.x(), s.carrier.point.y(), 0.0), up),
                           std::abs(s.carrier.radius));
      wire.Add(BRepBuilderAPI_MakeEdge(circle, from, to).Edge());
    }
    if (!wire.IsDone()) return {};
    BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), wire.Wire());
    if (!face.IsDone()) return {};
    return face.Shape();
  }

  GProp_GProps properties() const {
    GProp_GProps all;
    BRepGProp::SurfaceProperties(m_shape, all);
    return all;
  }

  TopoDS_Shape m_shape;
  int m_failures = 0;
};

}  // namespace handwheel::bench
