// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ConeProjection.h"
#include "proximity/TriangleIntersection.h"

#include <array>
#include <span>

namespace handwheel {

// A triangle that stopped the proxy.
struct TouchedFace {
  TrianglePoints corners;
  bool wound = false;  // true: the proxy is on the outer side, from which the corners are counter-clockwise
};

// The contact constraint planes that are active at the proxy. Each is the half-space in which a step from the present
// position must stay to keep the skin distance from its triangle. The planes are used on the servo thread, and take a
// fixed amount of memory.
class ContactPlanes {
 public:
  // Removes all planes and sets the position of the proxy.
  void beginAt(const Vec3& position);
  bool empty() const { return m_count == 0; }
  std::size_t size() const { return m_count; }
  std::span<const HalfSpace> all() const { return {m_planes.data(), m_count}; }
  const TouchedFace& lastFace() const { return m_faces[m_count - 1]; }

  // Adds a plane. If the set is full, the first plane is removed; if that plane still matters, a later sweep hits it
  // again.
  void add(const HalfSpace& plane, const TouchedFace& face);
  bool contains(const HalfSpace& plane) const;
  // Moves the proxy. All planes stay active while the proxy is within the skin distance of the position where it met
  // them. Farther away, only the planes that keepBelow() keeps stay active: the proxy is about the skin distance above
  // their triangles, so that a sweep would hit them at once.
  void moveTo(const Vec3& position, double skin);
  // Keeps only the planes whose triangles are directly below the proxy. A proxy that arrived at an angle may be beside
  // a triangle, at the edge of a hole, where another path down is free.
  void keepBelow(double skin);

 private:
  // The capacity is not a fidelity setting: three planes can hold a point, and the next sweep hits a removed plane
  // again.
  static constexpr std::size_t kCapacity = 8;

  void letFirstGo();

  std::array<HalfSpace, kCapacity> m_planes;
  std::array<TouchedFace, kCapacity> m_faces;
  std::size_t m_count = 0;
  Vec3 m_position = Vec3::Zero();  // the point to which the planes are relative
  Vec3 m_met = Vec3::Zero();       // the point near which the planes were met
};

}  // namespace handwheel
