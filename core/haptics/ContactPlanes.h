// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ConeProjection.h"
#include "proximity/TriangleIntersection.h"

#include <array>
#include <span>

namespace handwheel {

// A triangle that a proxy was stopped by.
struct TouchedFace {
  TrianglePoints corners;
  bool wound = false;  // the side touched is the one that the winding calls outside
};

// The planes that a proxy has met at one place, each as what a step from there must keep to stay off by the skin. On
// the servo thread: fixed memory.
class ContactPlanes {
 public:
  // Nothing has been met at this place.
  void beginAt(const Vec3& place);
  bool empty() const { return m_count == 0; }
  std::size_t size() const { return m_count; }
  std::span<const HalfSpace> all() const { return {m_planes.data(), m_count}; }
  const TouchedFace& lastFace() const { return m_faces[m_count - 1]; }

  // Where there are too many, the first is let go; it is met again where it matters.
  void add(const HalfSpace& plane, const TouchedFace& face);
  bool contains(const HalfSpace& plane) const;
  // The proxy goes on to this place. Within the skin of where they were met they all stand; farther on those alone that
  // keepBelow() keeps: about the skin above the triangle itself, so that a sweep would meet them at once.
  void moveTo(const Vec3& place, double skin);
  // Only those stand that it is right over. Where it came aslant, it may stand beside a triangle, at the edge of a
  // hole, and another way down is free.
  void keepBelow(double skin);

 private:
  static constexpr std::size_t kCapacity = 8;

  void letFirstGo();

  std::array<HalfSpace, kCapacity> m_planes;
  std::array<TouchedFace, kCapacity> m_faces;
  std::size_t m_count = 0;
  Vec3 m_place = Vec3::Zero();  // that the planes are told from
  Vec3 m_met = Vec3::Zero();    // near which they were met
};

}  // namespace handwheel
