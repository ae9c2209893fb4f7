// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/PartSurface.h"

#include "mesh/structure/AngleBetween.h"
#include "proximity/BoxQueries.h"
#include "proximity/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace handwheel {

namespace {

// Returns the index of the first equal point for each point.
std::vector<std::uint32_t> weldedNumbers(const std::vector<Vec3>& points) {
  std::vector<std::uint32_t> order(points.size()), numbers(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto isBefore = [&](std::uint32_t i, std::uint32_t j) {
    return std::lexicographical_compare(points[i].begin(), points[i].end(), points[j].begin(), points[j].end());
  };
  std::sort(order.begin(), order.end(), isBefore);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool isSame = i > 0 && points[order[i]] == points[order[i - 1]];
    numbers[order[i]] = isSame ? numbers[order[i - 1]] : order[i];
  }
  return numbers;
}

}  // namespace

PartSurface::PartSurface(const TriangleSoup& soup, const EdgeSettings& settings)
    : m_settings(settings), m_points(soup.points) {
  const std::vector<std::uint32_t> welded = weldedNumbers(m_points);
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> facesOf;
  for (const Triangle& triangle : soup.triangles) {
    const Triangle t{welded[triangle[0]], welded[triangle[1]], welded[triangle[2]]};
    const Vec3 across = (m_points[t[1]] - m_points[t[0]]).cross(m_points[t[2]] - m_points[t[0]]);
    if (!(across.norm() > 0.0) || !across.allFinite()) continue;
    for (std::size_t i = 0; i < 3; ++i)
      facesOf[std::minmax(t[i], t[(i + 1) % 3])].push_back(static_cast<std::uint32_t>(m_triangles.size()));
    m_triangles.push_back(t);
    m_normals.push_back(across.normalized());
  }
  for (const auto& [ends, faces] : facesOf) {
    const Vec3& first = m_normals[faces.front()];
    const Vec3& last = m_normals[faces.back()];
    if (faces.size() == 2 && angleBetween(first, last) < settings.sharpness) continue;
    const Vec3 sum = first + last;
    m_sharp.push_back({ends.first, ends.second, sum.norm() > 1e-9 ? Vec3(sum.normalized()) : first});
  }
  m_firstOfVertex.assign(m_points.size() + 1, 0);
  for (const Edge& edge : m_sharp) {
    ++m_firstOfVertex[edge.a + 1];
    ++m_firstOfVertex[edge.b + 1];
  }
  std::partial_sum(m_firstOfVertex.begin(), m_firstOfVertex.end(), m_firstOfVertex.begin());
  m_sharpOfVertex.resize(m_firstOfVertex.back());
  std::vector<std::uint32_t> free(m_firstOfVertex.begin(), m_firstOfVertex.end() - 1);
  for (std::uint32_t e = 0; e < m_sharp.size(); ++e) {
    m_sharpOfVertex[free[m_sharp[e].a]++] = e;
    m_sharpOfVertex[free[m_sharp[e].b]++] = e;
  }
  buildTree();
}

void PartSurface::buildTree() {
  m_frame = BoxFrame(m_points);
  std::vector<BoxedItem> items = boxedTriangles(m_points, m_triangles, m_frame, FlatTriangles::Keep);
  m_tree.build(items);
  for (const BoxedItem& item : items) m_order.push_back(item.id());
}

// Returns the edge that continues straightest at a vertex.
std::optional<std::uint32_t> PartSurface::next(std::uint32_t edge, std::uint32_t vertex) const {
  const auto away = [&](std::uint32_t e) {
    const std::uint32_t other = m_sharp[e].a == vertex ? m_sharp[e].b : m_sharp[e].a;
    return Vec3(m_points[other] - m_points[vertex]);
  };
  const Vec3 along = -away(edge);
  double least = m_settings.corner;
  std::optional<std::uint32_t> straightest;
  for (std::uint32_t i = m_firstOfVertex[vertex]; i < m_firstOfVertex[vertex + 1]; ++i) {
    const std::uint32_t e = m_sharpOfVertex[i];
    const double turn = angleBetween(along, away(e));
    if (e == edge || turn > least) continue;
    least = turn;
    straightest = e;
  }
  return straightest;
}

PartSurface::Chain PartSurface::chainThrough(std::uint32_t edge) const {
  Chain chain;
  std::vector<bool> isUsed(m_sharp.size(), false);
  isUsed[edge] = true;
  const auto follow = [&](std::uint32_t vertex, std::vector<std::uint32_t>& edges, std::vector<std::uint32_t>& ends) {
    std::uint32_t e = edge;
    ends.push_back(vertex);
    while (const auto on = next(e, vertex)) {
      if (*on == edge) return true;
      if (isUsed[*on]) return false;
      isUsed[*on] = true;
      e = *on;
      vertex = m_sharp[e].a == vertex ? m_sharp[e].b : m_sharp[e].a;
      edges.push_back(e);
      ends.push_back(vertex);
    }
    return false;
  };
  std::vector<std::uint32_t> back, backEnds;
  chain.isClosed = follow(m_sharp[edge].b, chain.edges, chain.vertices);
  if (!chain.isClosed) follow(m_sharp[edge].a, back, backEnds);
  std::reverse(back.begin(), back.end());
  std::reverse(backEnds.begin(), backEnds.end());
  if (chain.isClosed) backEnds.push_back(m_sharp[edge].a);
  back.push_back(edge);
  chain.edges.insert(chain.edges.begin(), back.begin(), back.end());
  chain.vertices.insert(chain.vertices.begin(), backEnds.begin(), backEnds.end());
  return chain;
}

SurfaceTrack PartSurface::edgeNear(const Vec3& position, double farthest) const {
  std::optional<std::uint32_t> nearest;
  double least = farthest;
  for (std::uint32_t e = 0; e < m_sharp.size(); ++e) {
    const double distance = distanceToSegment(position, m_points[m_sharp[e].a], m_points[m_sharp[e].b]);
    if (!(distance <= least)) continue;
    least = distance;
    nearest = e;
  }
  SurfaceTrack track;
  if (!nearest) return track;
  const Chain chain = chainThrough(*nearest);
  track.isClosed = chain.isClosed;
  const std::size_t count = chain.edges.size();
  for (std::size_t i = 0; i <= count; ++i) {
    Vec3 normal = Vec3::Zero();
    if (i > 0 || chain.isClosed) normal += m_sharp[chain.edges[(i + count - 1) % count]].normal;
    if (i < count || chain.isClosed) normal += m_sharp[chain.edges[i % count]].normal;
    track.points.push_back({m_points[chain.vertices[i]], Vec3::Zero(), normal.normalized()});
  }
  orient(track);
  return track;
}

TrackPoint PartSurface::pointNear(const Vec3& position) const {
  TrackPoint nearest{position, Vec3::Zero(), Vec3::Zero()};
  if (m_order.empty() || !position.allFinite()) return nearest;
  double least = std::numeric_limits<double>::infinity();
  std::uint32_t number = kNone;
  const PointToBox point(m_frame.toFrame(position));
  visitBestFirst(
      m_tree, [&](const FloatBox& box) { return point.squaredDistance(box); },
      [&] { return least * m_frame.scale() * m_frame.scale(); },
      [&](std::uint32_t begin, std::uint32_t end) {
        for (std::uint32_t i = begin; i < end; ++i) {
          const std::uint32_t t = m_order[i];
          const Triangle& corners = m_triangles[t];
          const Vec3 at = closestOnTriangle(position, m_points[corners[0]], m_points[corners[1]], m_points[corners[2]]);
          const double distance = (position - at).squaredNorm();
          if (!(distance < least || (distance == least && t < number))) continue;
          least = distance;
          number = t;
          nearest = {at, Vec3::Zero(), m_normals[t]};
        }
      });
  return nearest;
}

// Returns triangles in their order; includes all that the plane cuts.
std::vector<std::uint32_t> PartSurface::trianglesNear(const Vec3& onPlane, const Vec3& normal) const {
  std::vector<std::uint32_t> near;
  const Vec3 on = m_frame.toFrame(onPlane);
  constexpr double kRounding = 1e-9;  // in the frame of the tree, where coordinates are about 1
  const double slack = kRounding * (1.0 + on.cwiseAbs().maxCoeff());
  for (std::uint32_t node = 0; node < m_tree.nodeCount();) {
    const BoxNode& n = m_tree.node(node);
    const Vec3 low = n.box.low.head<3>().cast<double>(), high = n.box.high.head<3>().cast<double>();
    const double middle = (0.5 * (low + high) - on).dot(normal);
    if (std::abs(middle) > 0.5 * (high - low).dot(normal.cwiseAbs()) + slack) {
      node += n.size();
      continue;
    }
    if (n.isLeaf()) {
      for (std::uint32_t i = n.first(); i < m_tree.leafEnd(node); ++i) near.push_back(m_order[i]);
    }
    ++node;
  }
  std::sort(near.begin(), near.end());
  return near;
}

struct PartSurface::Section {
  using EndEdge =
      std::pair<std::uint32_t, std::uint32_t>;  // an edge of the surface that the plane cuts, at an end of a segment
  struct Segment {
    std::array<EndEdge, 2> ends;
    std::uint32_t triangle;
  };
  std::vector<Segment> segments;
  std::map<EndEdge, std::vector<std::uint32_t>> segmentsAt;
  std::map<EndEdge, Vec3> pointAt;
  std::uint32_t nearest = 0;  // index of the segment nearest to the position
};

PartSurface::Section PartSurface::sectionOf(const Vec3& onPlane, const Vec3& normal, const Vec3& position) const {
  // Points in the plane count as above it, so that the plane never goes through a vertex.
  const auto isAbove = [&](std::uint32_t i) { return (m_points[i] - onPlane).dot(normal) >= 0.0; };
  const auto pointOn = [&](const Section::EndEdge& edge) {
    const Vec3 &a = m_points[edge.first], &b = m_points[edge.second];
    const double from = (a - onPlane).dot(normal), to = (b - onPlane).dot(normal);
    return Vec3(a + from / (from - to) * (b - a));
  };
  Section section;
  double least = std::numeric_limits<double>::infinity();
  for (const std::uint32_t t : trianglesNear(onPlane, normal)) {
    const Triangle& corners = m_triangles[t];
    Section::Segment segment{{}, t};
    std::size_t found = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = corners[i], b = corners[(i + 1) % 3];
      if (isAbove(a) != isAbove(b) && found < 2) segment.ends[found++] = std::minmax(a, b);
    }
    if (found < 2) continue;
    const auto number = static_cast<std::uint32_t>(section.segments.size());
    for (const Section::EndEdge& end : segment.ends) {
      section.segmentsAt[end].push_back(number);
      section.pointAt.emplace(end, pointOn(end));
    }
    const double distance =
        distanceToSegment(position, section.pointAt.at(segment.ends[0]), section.pointAt.at(segment.ends[1]));
    if (distance < least) {
      least = distance;
      section.nearest = number;
    }
    section.segments.push_back(segment);
  }
  return section;
}

SurfaceTrack PartSurface::sectionNear(const Vec3& onPlane, const Vec3& normal, const Vec3& position) const {
  const Section section = sectionOf(onPlane, normal, position);
  SurfaceTrack track;
  if (section.segments.empty()) return track;
  std::vector<bool> isUsed(section.segments.size(), false);
  isUsed[section.nearest] = true;
  const auto follow = [&](Section::EndEdge end) {
    std::vector<TrackPoint> points;
    Vec3 before = m_normals[section.segments[section.nearest].triangle];
    for (;;) {
      std::optional<std::uint32_t> on;
      for (const std::uint32_t s : section.segmentsAt.at(end)) {
        if (!isUsed[s]) on = s;
      }
      const Vec3 after = on ? m_normals[section.segments[*on].triangle] : before;
      points.push_back({section.pointAt.at(end), Vec3::Zero(), (before + after).normalized()});
      if (!on) return points;
      isUsed[*on] = true;
      const auto& ends = section.segments[*on].ends;
      end = ends[0] == end ? ends[1] : ends[0];
      before = after;
    }
  };
  std::vector<TrackPoint> ahead = follow(section.segments[section.nearest].ends[1]);
  track.points = follow(section.segments[section.nearest].ends[0]);
  std::reverse(track.points.begin(), track.points.end());
  track.points.insert(track.points.end(), ahead.begin(), ahead.end());
  // Cut vertices give coincident points.
  const auto isSame = [](const TrackPoint& a, const TrackPoint& b) { return (a.position - b.position).norm() < 1e-9; };
  track.points.erase(std::unique(track.points.begin(), track.points.end(), isSame), track.points.end());
  if (track.points.size() < 2) return {};
  track.isClosed = track.points.size() > 2 && isSame(track.points.front(), track.points.back());
  orient(track);
  return track;
}

}  // namespace handwheel
