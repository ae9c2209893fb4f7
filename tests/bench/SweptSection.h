// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurningPass.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <vector>

// The half section of a turned part, as a reference for TurnedProfile. It is computed by exact boolean operations on
// polygons.
namespace handwheel::bench {

struct SectionDistance {
  double smooth = 0.0, atShoulders = 0.0;  // mm
};

class SweptSection {
 public:
  SweptSection(double radius, double length) {
    Polygon bar;
    for (const auto& [r, z] : {std::pair{0.0, 0.0}, {radius, 0.0}, {radius, length}, {0.0, length}})
      bar.push_back({r, z});
    m_set.insert(bar);
  }

  // Removes the area that the nose and shank of the tool sweep. For each step of the path it is the convex hull of four
  // discs: two at the ends of the step, and two shifted radially by 100 mm, outwards or for a bore inwards.
  void cut(const TurningPass& pass) {
    Set swept;
    std::vector<Polygon> all;
    const double far = pass.side == TurningSide::Bore ? -100.0 : 100.0;
    for (std::size_t i = 1; i < pass.path.size(); ++i) {
      std::vector<Point> points;
      for (const ProfilePoint& c : {pass.path[i - 1], pass.path[i]}) {
        for (const double shift : {0.0, far}) addDisc(points, c + ProfilePoint(shift, 0.0), pass.noseRadius);
      }
      Polygon hull;
      CGAL::convex_hull_2(points.begin(), points.end(), std::back_inserter(hull));
      all.push_back(std::move(hull));
    }
    swept.join(all.begin(), all.end());
    m_set.difference(swept);
  }

  double volume() const {
    double sum = 0.0;
    for (const Edge& e : edges()) {
      sum += (e.b.y() - e.a.y()) * (e.a.x() * e.a.x() + e.a.x() * e.b.x() + e.b.x() * e.b.x());
    }
    return M_PI / 3.0 * sum;
  }

  // Returns the largest distance between the boundaries of the section and the profile, in both directions, without the
  // axis. A point belongs to a shoulder if it is within 0.05 mm of a wall that is perpendicular to the axis and higher
  // than 0.01 mm.
  SectionDistance distanceTo(const TurnedProfile& profile) const {
    std::vector<Edge> own;
    std::vector<Edge> walls;
    for (const Edge& e : edges()) {
      if (e.a.x() < 1e-9 && e.b.x() < 1e-9) continue;
      own.push_back(e);
      if (std::abs(e.a.y() - e.b.y()) < 1e-3 * std::abs(e.a.x() - e.b.x()) && std::abs(e.a.x() - e.b.x()) > 0.01)
        walls.push_back(e);
    }
    std::vector<Edge> sampled;
    const std::size_t last = profile.size() - 1;
    for (std::size_t i = 0; i < last; ++i) {
      sampled.push_back({{profile.radius(i), profile.z(i)}, {profile.radius(i + 1), profile.z(i + 1)}});
      sampled.push_back({{profile.inner(i), profile.z(i)}, {profile.inner(i + 1), profile.z(i + 1)}});
    }
    for (const std::size_t i : {std::size_t{0}, last})
      sampled.push_back({{profile.inner(i), profile.z(i)}, {profile.radius(i), profile.z(i)}});
    SectionDistance distance;
    const auto compare = [&](const std::vector<Edge>& from, const std::vector<Edge>& to) {
      const Grid grid(to);
      for (const Edge& e : from) {
        const int steps = 1 + static_cast<int>((e.b - e.a).norm() / 0.005);
        for (int k = 0; k <= steps; ++k) {
          const ProfilePoint p = e.a + double(k) / steps * (e.b - e.a);
          if (p.x() < 1e-6) continue;
          const double off = grid.distance(p);
          const bool isAtWall =
              std::any_of(walls.begin(), walls.end(), [&](const Edge& w) { return w.distance(p) < 0.05; });
          double& worst = isAtWall ? distance.atShoulders : distance.smooth;
          worst = std::max(worst, off);
        }
      }
    };
    compare(own, sampled);
    compare(sampled, own);
    return distance;
  }

 private:
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Point = Kernel::Point_2;
  using Polygon = CGAL::Polygon_2<Kernel>;
  using Set = CGAL::Polygon_set_2<Kernel>;

  struct Edge {
    ProfilePoint a, b;
    double distance(const ProfilePoint& p) const {
      const ProfilePoint along = b - a;
      const double length = along.squaredNorm();
      const double t = length > 0.0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0.0;
      return (p - a - t * along).norm();
    }
  };

  // Edges sorted along the axis into slices of 0.05 mm. A query searches only edges that are at most one slice away.
  class Grid {
   public:
    explicit Grid(const std::vector<Edge>& edges) {
      for (const Edge& e : edges) {
        const auto [low, high] = std::minmax(e.a.y(), e.b.y());
        for (int i = slice(low) - 1; i <= slice(high) + 1; ++i) {
          if (i < 0) continue;
          if (m_slices.size() <= static_cast<std::size_t>(i)) m_slices.resize(static_cast<std::size_t>(i) + 1);
          m_slices[static_cast<std::size_t>(i)].push_back(e);
        }
      }
    }
    double distance(const ProfilePoint& p) const {
      double least = 1e9;
      const auto i = static_cast<std::size_t>(std::max(0, slice(p.y())));
      if (i >= m_slices.size()) return least;
      for (const Edge& e : m_slices[i]) least = std::min(least, e.distance(p));
      return least;
    }

   private:
    static int slice(double z) { return static_cast<int>(std::floor(z / 0.05)); }
    std::vector<std::vector<Edge>> m_slices;
  };

  // Adds the corners of a regular polygon for a disc. With 240 sides the error is 9e-5 of the radius.
  static void addDisc(std::vector<Point>& points, const ProfilePoint& centre, double radius) {
    constexpr int kSides = 240;
    for (int i = 0; i < kSides; ++i) {
      const double angle = 2.0 * M_PI * i / kSides;
      points.emplace_back(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle));
    }
  }

  // Returns the boundaries of all parts, with the material on the left.
  std::vector<Edge> edges() const {
    std::list<CGAL::Polygon_with_holes_2<Kernel>> parts;
    m_set.polygons_with_holes(std::back_inserter(parts));
    std::vector<Edge> all;
    const auto add = [&](const Polygon& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
        all.push_back(
            {{CGAL::to_double(a.x()), CGAL::to_double(a.y())}, {CGAL::to_double(b.x()), CGAL::to_double(b.y())}});
      }
    };
    for (const auto& part : parts) {
      add(part.outer_boundary());
      for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) add(*hole);
    }
    return all;
  }

  Set m_set;
};

}  // namespace handwheel::bench
