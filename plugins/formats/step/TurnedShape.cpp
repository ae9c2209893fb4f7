// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "step/TurnedShape.h"

#include "step/RevolutionAxis.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepTools.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gp_Sphere.hxx>

namespace handwheel {

namespace {

constexpr double kConcentric = 1e-4;  // mm
constexpr int kPerSpan = 32;          // points on a piece of a curve

// Distance from the axis and height along it; mm.
struct Meridian {
  double r, z;
};

class Section {
 public:
  explicit Section(const gp_Ax1& axis) : m_axis(axis) {}

  void add(const ExaminedFace& face) {
    switch (face.surface.GetType()) {
      case GeomAbs_Plane:
        addPlane(face);
        break;
      case GeomAbs_Cylinder:
      case GeomAbs_Cone:
        addLine(at(face, true, face.v[0]), at(face, true, face.v[1]));
        break;
      case GeomAbs_Torus:
        addArc(face);
        break;
      case GeomAbs_Sphere:
        if (face.surface.Sphere().Position().Direction().IsParallel(m_axis.Direction(), 1e-6)) {
          addArc(face);
        } else {
          addTiltedBall(face);
        }
        break;
      default:
        addCurve(face);
    }
  }
  const std::string& lines() const { return m_lines; }

 private:
  Meridian of(const gp_Pnt& p) const {
    const gp_Vec to(m_axis.Location(), p), along(m_axis.Direction());
    return {along.Crossed(to).Magnitude(), along.Dot(to)};
  }
  // In the middle of the other parameter.
  Meridian at(const ExaminedFace& face, bool isAlongV, double parameter) const {
    const double other = isAlongV ? 0.5 * (face.u[0] + face.u[1]) : 0.5 * (face.v[0] + face.v[1]);
    return of(isAlongV ? face.surface.Value(other, parameter) : face.surface.Value(parameter, other));
  }
  void write(const char* word, std::initializer_list<Meridian> points) {
    m_lines += word;
    for (const Meridian& p : points) append(p);
    m_lines += "\n";
  }
  void append(const Meridian& p) {
    char text[80];
    std::snprintf(text, sizeof text, " %.17g %.17g", p.r, p.z);
    m_lines += text;
  }
  void addLine(const Meridian& a, const Meridian& b) { write("line", {a, b}); }

  // In two halves, as it may be more than half a circle.
  void addArc(const ExaminedFace& face) {
    const auto point = [&](int eighth) { return at(face, true, face.v[0] + 0.25 * eighth * (face.v[1] - face.v[0])); };
    write("arc", {point(0), point(1), point(2)});
    write("arc", {point(2), point(3), point(4)});
  }

  // By the angles of its points, as its own poles are elsewhere.
  void addTiltedBall(const ExaminedFace& face) {
    const gp_Sphere ball = face.surface.Sphere();
    const Meridian centre = of(ball.Location());
    double least = M_PI, most = -M_PI;
    constexpr int kFine = 200;
    for (int i = 0; i <= kFine; ++i) {
      for (int k = 0; k <= kFine; ++k) {
        const Meridian p = of(face.surface.Value(face.u[0] + (face.u[1] - face.u[0]) * i / kFine,
                                                 face.v[0] + (face.v[1] - face.v[0]) * k / kFine));
        const double angle = std::atan2(p.z - centre.z, p.r);
        least = std::min(least, angle);
        most = std::max(most, angle);
      }
    }
    const auto point = [&](double t) {
      const double angle = least + t * (most - least);
      return Meridian{std::max(0.0, ball.Radius() * std::cos(angle)), centre.z + ball.Radius() * std::sin(angle)};
    };
    write("arc", {point(0.0), point(0.25), point(0.5)});
    write("arc", {point(0.5), point(0.75), point(1.0)});
  }

  // A ring or disc: the radii of its concentric edges.
  void addPlane(const ExaminedFace& face) {
    const TopoDS_Wire outer = BRepTools::OuterWire(face.face);
    double least = HUGE_VAL, most = 0.0, hole = 0.0, z = 0.0;
    bool isOneCircle = true;
    for (TopExp_Explorer wires(face.face, TopAbs_WIRE); wires.More(); wires.Next()) {
      double low = HUGE_VAL, high = 0.0;
      for (TopExp_Explorer edges(wires.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(edges.Current()));
        for (int i = 0; i <= 16; ++i) {
          const double share = i / 16.0;
          const Meridian p = of(curve.Value((1.0 - share) * curve.FirstParameter() + share * curve.LastParameter()));
          low = std::min(low, p.r);
          high = std::max(high, p.r);
          z = p.z;
        }
      }
      const bool isCircle = high - low < kConcentric;
      if (wires.Current().IsSame(outer)) {
        least = low;
        most = high;
        isOneCircle = isCircle;
      } else if (isCircle) {
        hole = std::max(hole, 0.5 * (low + high));
      }
    }
    addLine({isOneCircle ? hole : least, z}, {most, z});
  }

  // The parameter along which a face stays in a half plane of the axis.
  bool isMeridianAlongV(const ExaminedFace& face) const {
    if (face.surface.GetType() == GeomAbs_SurfaceOfRevolution) return true;
    double off[2] = {0.0, 0.0};
    for (const bool isAlongV : {false, true}) {
      const double other = isAlongV ? 0.5 * (face.u[0] + face.u[1]) : 0.5 * (face.v[0] + face.v[1]);
      const double from = isAlongV ? face.v[0] : face.u[0], to = isAlongV ? face.v[1] : face.u[1];
      const auto point = [&](double t) {
        const double p = from + t * (to - from);
        return isAlongV ? face.surface.Value(other, p) : face.surface.Value(p, other);
      };
      const gp_Vec across = gp_Vec(m_axis.Direction()).Crossed(gp_Vec(m_axis.Location(), point(0.4)));
      for (const double t : {0.1, 0.2, 0.6, 0.7, 0.9})
        off[isAlongV ? 1 : 0] =
            std::max(off[isAlongV ? 1 : 0], std::abs(across.Dot(gp_Vec(m_axis.Location(), point(t)))));
    }
    return off[1] <= off[0];
  }

  void addCurve(const ExaminedFace& face) {
    const bool isAlongV = isMeridianAlongV(face);
    const double from = isAlongV ? face.v[0] : face.u[0], to = isAlongV ? face.v[1] : face.u[1];
    const int spans = isAlongV ? face.surface.NbVIntervals(GeomAbs_C1) : face.surface.NbUIntervals(GeomAbs_C1);
    TColStd_Array1OfReal knots(1, spans + 1);
    if (isAlongV) {
      face.surface.VIntervals(knots, GeomAbs_C1);
    } else {
      face.surface.UIntervals(knots, GeomAbs_C1);
    }
    std::vector<double> breaks{from};
    for (int i = knots.Lower(); i <= knots.Upper(); ++i)
      if (knots(i) > from && knots(i) < to) breaks.push_back(knots(i));
    breaks.push_back(to);
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      m_lines += "points " + std::to_string(kPerSpan + 1);
      for (int k = 0; k <= kPerSpan; ++k) {
        const double t = static_cast<double>(k) / kPerSpan;
        append(at(face, isAlongV, (1.0 - t) * breaks[i] + t * breaks[i + 1]));
      }
      m_lines += "\n";
    }
  }

  gp_Ax1 m_axis;
  std::string m_lines;
};

const char* kindOf(const ExaminedFace& face) {
  switch (face.surface.GetType()) {
    case GeomAbs_Plane:
      return "plane";
    case GeomAbs_Cylinder:
      return "cylinder";
    case GeomAbs_Cone:
      return "cone";
    case GeomAbs_Sphere:
      return "sphere";
    case GeomAbs_Torus:
      return "torus";
    case GeomAbs_BSplineSurface:
    case GeomAbs_BezierSurface:
      return "spline";
    case GeomAbs_SurfaceOfExtrusion:
      return "extrusion";
    default:
      return "surface";
  }
}

int bodiesIn(const TopoDS_Shape& shape) {
  int solids = 0, shells = 0;
  for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next()) ++solids;
  for (TopExp_Explorer each(shape, TopAbs_SHELL, TopAbs_SOLID); each.More(); each.Next()) ++shells;
  return solids + shells;
}

}  // namespace

std::string turnedAnswer(const TopoDS_Shape& shape, bool isLenient) {
  const int bodies = bodiesIn(shape);
  if (bodies != 1) return "solids " + std::to_string(bodies) + "\n";
  const std::vector<ExaminedFace> faces = examine(shape);
  const std::optional<gp_Ax1> axis = axisOf(faces);
  if (!axis) return "no-axis\n";
  Section section(*axis);
  int ignored = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const ExaminedFace& face = faces[i];
    if (isOfRevolution(face, *axis)) {
      section.add(face);
    } else if (isLenient) {
      ++ignored;
    } else {
      const gp_Pnt p = face.surface.Value(0.5 * (face.u[0] + face.u[1]), 0.5 * (face.v[0] + face.v[1]));
      char text[160];
      std::snprintf(text, sizeof text, "face %zu %s %.9g %.9g %.9g\n", i + 1, kindOf(face), p.X(), p.Y(), p.Z());
      return text;
    }
  }
  return "turned " + std::to_string(ignored) + "\n" + section.lines();
}

}  // namespace handwheel
