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
  bool wound = false;  // the touched side is the outside by winding order
};

// The contact constraint planes that are active at the proxy. Each is the half-space that a step from the present
// position must stay in to keep the skin distance from its triangle. Servo thread; fixed memory.
class ContactPlanes {
 public:
  // Removes all planes and sets the position of the proxy.
  void beginAt(const Vec3& position);
  bool empty() const { return m_count == 0; }
  std::size_t size() const { return m_count; }
  std::span<const HalfSpace> all() const { return {m_planes.data(), m_count}; }
  const TouchedFace& lastFace() const { return m_faces[m_count - 1]; }

  // If the set is full, the first plane is removed; a later sweep hits it again where it matters.
  void add(const HalfSpace& plane, const TouchedFace& face);
  bool contains(const HalfSpace& plane) const;
  // Moves the proxy. Within the skin distance of the position where the planes were met, all of them stay active;
  // farther away only those that keepBelow() keeps: with the proxy about the skin above the triangle itself, so that a
  // sweep would hit them at once.
  void moveTo(const Vec3& position, double skin);
  // Keeps only the planes with the proxy directly above their triangle. A proxy that arrived at an angle may be beside
  // a triangle, at the edge of a hole, where another path down is free.
  void keepBelow(double skin);

 private:
  // Not a fidelity setting: three planes carry a point, and a plane that was released is met again by the next sweep.
  static constexpr std::size_t kCapacity = 8;

  void letFirstGo();

  std::array<HalfSpace, kCapacity> m_planes;
  std::array<TouchedFace, kCapacity> m_faces;
  std::size_t m_count = 0;
  Vec3 m_position = Vec3::Zero();  // the point that the planes are relative to
  Vec3 m_met = Vec3::Zero();       // the point near which they were met
};

}  // namespace handwheel
