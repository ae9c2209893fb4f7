// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/section/ToolSweep.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

// A half section with exact boolean operations by CGAL. It is the reference for TurnedSection.
//
// All circles have a rational centre and radius, and all lines rational ends. A direction is replaced by a unit vector
// with rational coordinates within 1e-15 of it, so that a line begins exactly on the circle that it touches.
namespace handwheel::test {

class ExactSection {
 public:
  struct Piece {
    double area = 0.0, volume = 0.0;  // mm², mm³
    ProfileBox box;
  };

  ExactSection(double radius, double length) {
    m_set.insert(polygon({{0, 0}, {radius, 0}, {radius, length}, {0, length}}));
  }

  // Subtracts the area that a shape sweeps on a move.
  void cut(const SweptShape& shape, const ProfileSegment& move) {
    Set swept;
    if (move.isArc()) {
      addArc(swept, shape, move);
    } else {
      std::vector<ProfilePoint> all;
      for (const ProfilePoint& p : shape.corners) {
        all.emplace_back(p + move.from);
        all.emplace_back(p + move.to);
      }
      addHull(swept, all, shape.radius);
    }
    m_set.difference(swept);
  }

  // Returns the pieces with at least this area.
  std::vector<Piece> pieces(double leastArea) const {
    std::vector<Piece> result;
    for (const Polygon& each : polygons()) {
      const Piece piece = pieceOf(each);
      if (piece.area >= leastArea) result.push_back(piece);
    }
    return result;
  }
  double area() const {
    double sum = 0.0;
    for (const Piece& piece : pieces(0.0)) sum += piece.area;
    return sum;
  }
  double volume() const {
    double sum = 0.0;
    for (const Piece& piece : pieces(0.0)) sum += piece.volume;
    return sum;
  }

  // Returns the boundary with the material on its left, as curves in double precision.
  std::vector<SectionSegment> boundary() const {
    std::vector<SectionSegment> all;
    for (const Polygon& each : polygons())
      eachCurve(each, [&](const Curve& curve) { all.push_back(segmentOf(curve)); });
    return all;
  }

 private:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Number = Kernel::FT;
  using Vector = Kernel::Vector_2;
  using Rational = Kernel::Point_2;
  using Traits = CGAL::Gps_circle_segment_traits_2<Kernel>;
  using Set = CGAL::General_polygon_set_2<Traits>;
  using Ring = Traits::Polygon_2;
  using Polygon = Traits::Polygon_with_holes_2;
  using Curve = Traits::X_monotone_curve_2;
  using Point = Traits::Point_2;

  static Rational exact(const ProfilePoint& p) { return {Number(p.x()), Number(p.y())}; }
  static Point pointOf(const Rational& p) { return {p.x(), p.y()}; }

  // Returns a rational unit vector near a direction.
  static Vector unit(const ProfilePoint& direction) {
    const ProfilePoint u = direction.normalized();
    const double x = std::abs(u.x()), y = std::abs(u.y());
    const Number t(std::min(x, y) / (1.0 + std::max(x, y))), square = t * t;
    const Number large = (1 - square) / (1 + square), small = 2 * t / (1 + square);
    const Number ux = x >= y ? large : small, uy = x >= y ? small : large;
    return {u.x() < 0.0 ? Number(-ux) : ux, u.y() < 0.0 ? Number(-uy) : uy};
  }
  // Returns the same for an angle. Near a multiple of 180° it is that exactly, because arcs are split there.
  static Vector unit(double angle) {
    const double cosine = std::cos(angle), sine = std::sin(angle);
    return unit({cosine, std::abs(sine) < 1e-12 ? 0.0 : sine});
  }

  static Ring polygon(const std::vector<ProfilePoint>& corners) {
    std::vector<Rational> points;
    for (const ProfilePoint& p : corners) points.push_back(exact(p));
    return polygonOf(points);
  }
  static Ring polygonOf(const std::vector<Rational>& corners) {
    Ring ring;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Rational &p = corners[i], &q = corners[(i + 1) % corners.size()];
      if (p != q) ring.push_back(Curve(p, q));
    }
    return ring;
  }

  static Ring disc(const Rational& centre, const Number& radius) {
    const Kernel::Circle_2 circle(centre, radius * radius, CGAL::COUNTERCLOCKWISE);
    const Point right(centre.x() + radius, centre.y()), left(centre.x() - radius, centre.y());
    Ring ring;
    ring.push_back(Curve(circle, right, left, CGAL::COUNTERCLOCKWISE));
    ring.push_back(Curve(circle, left, right, CGAL::COUNTERCLOCKWISE));
    return ring;
  }

  // Adds the hull of points, offset by a radius: a polygon, and a disc for each corner.
  static void addHull(Set& set, const std::vector<ProfilePoint>& all, double radius) {
    std::vector<Rational> points, hull, corners;
    for (const ProfilePoint& p : all) points.push_back(exact(p));
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    const Number r(radius);
    for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i) {
      const Rational &p = hull[i], &q = hull[(i + 1) % hull.size()];
      const Vector along = q - p;
      const Vector out = unit({CGAL::to_double(along.y()), -CGAL::to_double(along.x())}) * r;
      corners.push_back(p + out);
      corners.push_back(q + out);
    }
    if (corners.size() > 4 || (corners.size() == 4 && radius > 0.0)) set.join(polygonOf(corners));
    if (radius > 0.0)
      for (const Rational& p : hull) set.join(disc(p, r));
  }

  // An arc about a centre, between two directions less than 90° apart.
  struct Bow {
    Rational centre;
    Number radius;
    double from, to;  // rad, rising
  };

  // Appends an arc, split where its tangent is parallel to z. Returns its curves from the first direction to the last.
  static std::vector<Curve> curvesOf(const Bow& bow) {
    std::vector<Vector> directions{unit(bow.from)};
    for (double k = std::ceil(bow.from / M_PI); k * M_PI < bow.to; ++k)
      directions.push_back(Vector(std::fmod(k, 2.0) == 0.0 ? 1 : -1, 0));
    directions.push_back(unit(bow.to));
    const Kernel::Circle_2 circle(bow.centre, bow.radius * bow.radius, CGAL::COUNTERCLOCKWISE);
    std::vector<Curve> curves;
    for (std::size_t i = 0; i + 1 < directions.size(); ++i) {
      if (directions[i] == directions[i + 1]) continue;
      curves.emplace_back(circle, pointOf(bow.centre + bow.radius * directions[i]),
                          pointOf(bow.centre + bow.radius * directions[i + 1]), CGAL::COUNTERCLOCKWISE);
    }
    return curves;
  }

  static Curve reversed(const Curve& curve) { return Traits().construct_opposite_2_object()(curve); }

  // Adds the area between two bows with the same directions.
  static void addBetween(Set& set, const Bow& a, const Bow& b) {
    const auto end = [](const Bow& bow, double angle) -> Rational { return bow.centre + bow.radius * unit(angle); };
    std::vector<Curve> curves = curvesOf(a);
    curves.emplace_back(end(a, a.to), end(b, b.to));
    if (b.radius > 0) {
      const std::vector<Curve> back = curvesOf(b);
      for (auto curve = back.rbegin(); curve != back.rend(); ++curve) curves.push_back(reversed(*curve));
    }
    curves.emplace_back(end(b, b.from), end(a, a.from));
    double area = 0.0;
    for (const Curve& curve : curves) area += segmentOf(curve).moment();
    if (area < 0.0) {
      std::reverse(curves.begin(), curves.end());
      for (Curve& curve : curves) curve = reversed(curve);
    }
    set.join(Ring(curves.begin(), curves.end()));
  }

  // Adds the sweep along an arc: the shape at the ends, what each corner's disc sweeps, and what each edge sweeps.
  static void addArc(Set& set, const SweptShape& shape, const ProfileSegment& move) {
    std::vector<Rational> points, hull;
    for (const ProfilePoint& p : shape.corners) points.push_back(exact(p));
    CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
    const ProfilePoint centre = move.centre(), start = move.from - centre;
    const Number radius(move.radius()), r(shape.radius);
    const double begin = std::atan2(start.y(), start.x()), end = begin + move.angle();
    const double low = std::min(begin, end), high = std::max(begin, end);

    // Pieces of less than 90°. An edge folds where it is tangent to the arc: the shape is added there.
    constexpr double kFold = 1e-6;  // rad beside a fold; the gap is 1e-12 of the radius
    std::vector<double> stops{low, high}, folds;
    for (double k = 1.0; k < 6.0; ++k) stops.push_back(low + k / 6.0 * (high - low));
    for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i) {
      const Vector along = hull[(i + 1) % hull.size()] - hull[i];
      const double normal = std::atan2(-CGAL::to_double(along.x()), CGAL::to_double(along.y()));
      for (double k = std::ceil((low - normal) / M_PI - 0.01); normal + k * M_PI < high + 0.01; ++k)
        folds.push_back(normal + k * M_PI);
    }
    std::vector<double> shapes{low, high};
    for (const double fold : folds) {
      if (!(fold > low && fold < high)) continue;
      stops.push_back(fold);
      shapes.push_back(fold);
    }
    const auto isFold = [&](double angle) {
      return std::any_of(folds.begin(), folds.end(), [&](double fold) { return std::abs(angle - fold) < kFold; });
    };
    std::sort(stops.begin(), stops.end());
    for (const double angle : shapes) {
      std::vector<ProfilePoint> moved;
      for (const ProfilePoint& p : shape.corners)
        moved.emplace_back(p + centre + move.radius() * ProfilePoint(std::cos(angle), std::sin(angle)));
      addHull(set, moved, shape.radius);
    }
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const double first = stops[k], last = stops[k + 1];
      const double from = isFold(first) ? first + 2.0 * kFold : first, to = isFold(last) ? last - 2.0 * kFold : last;
      if (!(to - from > kFold)) continue;  // covered by the shape at the fold
      for (std::size_t i = 0; i < hull.size(); ++i) {
        const Rational corner = exact(centre) + (hull[i] - CGAL::ORIGIN);
        if (shape.radius > 0.0) {
          const Number inner = radius - r;
          addBetween(set, {corner, radius + r, first, last}, {corner, inner > 0 ? inner : Number(0), first, last});
        }
        if (hull.size() < 2) continue;
        const Vector along = hull[(i + 1) % hull.size()] - hull[i];
        const Vector out = unit({CGAL::to_double(along.y()), -CGAL::to_double(along.x())}) * r;
        addBetween(set, {corner + out, radius, from, to}, {corner + out + along, radius, from, to});
      }
    }
  }

  static SectionSegment segmentOf(const Curve& curve) {
    const auto rounded = [](const Point& p) { return ProfilePoint(CGAL::to_double(p.x()), CGAL::to_double(p.y())); };
    const ProfilePoint from = rounded(curve.source()), to = rounded(curve.target());
    if (curve.is_linear()) return SectionSegment::line(from, to);
    const Kernel::Circle_2 circle = curve.supporting_circle();
    const ProfilePoint centre(CGAL::to_double(circle.center().x()), CGAL::to_double(circle.center().y()));
    SectionSegment arc = SectionSegment::arc(centre, from, to, curve.orientation() == CGAL::COUNTERCLOCKWISE ? 1 : -1);
    arc.carrier.radius = std::copysign(std::sqrt(CGAL::to_double(circle.squared_radius())), arc.carrier.radius);
    return arc;
  }

  std::vector<Polygon> polygons() const {
    std::vector<Polygon> all;
    m_set.polygons_with_holes(std::back_inserter(all));
    return all;
  }

  template <class Take>
  static void eachCurve(const Polygon& polygon, Take take) {
    const auto ofRing = [&](const Ring& ring) {
      for (auto curve = ring.curves_begin(); curve != ring.curves_end(); ++curve) take(*curve);
    };
    ofRing(polygon.outer_boundary());
    for (auto hole = polygon.holes_begin(); hole != polygon.holes_end(); ++hole) ofRing(*hole);
  }

  // The integrals of r dz and r² dz along the boundary, in closed form.
  static Piece pieceOf(const Polygon& polygon) {
    Piece piece;
    eachCurve(polygon, [&](const Curve& curve) {
      const SectionSegment s = segmentOf(curve);
      const ProfilePoint a = s.from, b = s.to, c = s.carrier.point;
      const double rise = b.y() - a.y(), r = std::abs(s.carrier.radius);
      piece.box.extend(s.box());
      if (curve.is_linear()) {
        piece.area += 0.5 * (a.x() + b.x()) * rise;
        piece.volume += M_PI / 3.0 * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x()) * rise;
        return;
      }
      const double first = std::atan2(a.y() - c.y(), a.x() - c.x());
      double by = std::remainder(std::atan2(b.y() - c.y(), b.x() - c.x()) - first, 2.0 * M_PI);
      // The arcs are at most half circles; those of rounding may turn back.
      if (s.carrier.radius > 0.0 && by < -0.5 * M_PI) by += 2.0 * M_PI;
      if (s.carrier.radius < 0.0 && by > 0.5 * M_PI) by -= 2.0 * M_PI;
      // r = c.x + r cos θ and dz = r cos θ dθ.
      const auto square = [](double angle) { return 0.5 * angle + 0.25 * std::sin(2.0 * angle); };
      const auto cube = [](double angle) {
        const double sine = std::sin(angle);
        return sine - sine * sine * sine / 3.0;
      };
      const double last = first + by, ofCosine = std::sin(last) - std::sin(first);
      const double ofSquare = square(last) - square(first), ofCube = cube(last) - cube(first);
      piece.area += c.x() * r * ofCosine + r * r * ofSquare;
      piece.volume += M_PI * (c.x() * c.x() * r * ofCosine + 2.0 * c.x() * r * r * ofSquare + r * r * r * ofCube);
    });
    return piece;
  }

  Set m_set;
};

}  // namespace handwheel::test
