// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "planning/DrawnCurve.h"

namespace handwheel {

namespace {

constexpr double kSamePlace = 1e-6;  // mm
constexpr double kOnSection = 1e-6;  // of the way between two places, beside kSamePlace

}  // namespace

DrawnCurve::DrawnCurve(std::shared_ptr<const PartSurface> surface, const Vec3& begin)
    : m_surface(std::move(surface)), m_end(m_surface->placeNear(begin)) {}

bool DrawnCurve::goOnTo(const Vec3& place) {
  if (!place.allFinite()) return false;
  const TrackPoint next = m_surface->placeNear(place);
  const Vec3 way = next.place - m_end.place;
  const double length = way.norm();
  if (length < kSamePlace) return true;
  const Vec3 across = way.cross(m_end.normal + next.normal);
  if (!(across.norm() > 1e-6 * length)) return false;
  const SurfaceTrack section = m_surface->sectionNear(m_end.place, across.normalized(), m_end.place);
  SurfaceTrack piece =
      pieceBetween(section, m_end.place, next.place, kSamePlace + kOnSection * length + 1e-9 * next.place.norm());
  if (piece.points.size() < 2) return false;
  piece.points.front().normal = m_end.normal;  // of the faces that the places are on
  piece.points.back().normal = next.normal;
  auto begin = piece.points.begin();
  if (!m_track.points.empty()) {
    m_track.points.back().normal += begin->normal;
    ++begin;
  }
  for (; begin != piece.points.end(); ++begin) {
    const bool isApart = m_track.points.empty() || (begin->place - m_track.points.back().place).norm() > 0.0;
    if (isApart) m_track.points.push_back(*begin);
  }
  orient(m_track);
  m_end = next;
  return true;
}

}  // namespace handwheel
