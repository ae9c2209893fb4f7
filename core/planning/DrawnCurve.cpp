// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/DrawnCurve.h"

namespace handwheel {

namespace {

constexpr double kSamePoint = 1e-6;  // mm
constexpr double kOnSection = 1e-6;  // relative to the distance of two points, in addition to kSamePoint

}  // namespace

DrawnCurve::DrawnCurve(std::shared_ptr<const PartSurface> surface, const Vec3& begin)
    : m_surface(std::move(surface)), m_end(m_surface->pointNear(begin)) {}

bool DrawnCurve::goOnTo(const Vec3& position) {
  if (!position.allFinite()) return false;
  const TrackPoint next = m_surface->pointNear(position);
  const Vec3 chord = next.position - m_end.position;
  const double length = chord.norm();
  if (length < kSamePoint) return true;
  const Vec3 across = chord.cross(m_end.normal + next.normal);
  if (!(across.norm() > 1e-6 * length)) return false;
  const SurfaceTrack section = m_surface->sectionNear(m_end.position, across.normalized(), m_end.position);
  SurfaceTrack piece = pieceBetween(section, m_end.position, next.position,
                                    kSamePoint + kOnSection * length + 1e-9 * next.position.norm());
  if (piece.points.size() < 2) return false;
  piece.points.front().normal = m_end.normal;  // normals of the faces that the points are on
  piece.points.back().normal = next.normal;
  auto begin = piece.points.begin();
  if (!m_track.points.empty()) {
    m_track.points.back().normal += begin->normal;
    ++begin;
  }
  for (; begin != piece.points.end(); ++begin) {
    const bool isApart = m_track.points.empty() || (begin->position - m_track.points.back().position).norm() > 0.0;
    if (isApart) m_track.points.push_back(*begin);
  }
  orient(m_track);
  m_end = next;
  return true;
}

}  // namespace handwheel
