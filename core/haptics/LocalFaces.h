// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/ConeProjection.h"
#include "haptics/ContactSurface.h"

#include <array>
#include <optional>

namespace handwheel {

// The triangles around a proxy, looked up once and then swept against many times within a tick. On the servo thread:
// fixed memory.
class LocalFaces {
 public:
  // expected: where the proxy will go from its first place, as far as that can be told before; what is looked up first
  // lies around this way, so that one look-up mostly serves a tick.
  LocalFaces(const ContactSurface& surface, const Vec3& expected)
      : m_surface(surface), m_skin(surface.skin()), m_expected(expected) {}

  // How far ahead to look up, mm.
  void setReach(double reach) { m_reach = reach; }
  double reach() const { return m_reach; }
  // More triangles were there than it holds, so that the reach was shortened.
  bool crowded() const { return m_crowded; }

  struct Sweep {
    double fraction = 1.0;  // of the way gone: up to the skin over what is hit, or to the end of what is looked up
    std::optional<HalfSpace> hit;  // the plane that was hit, as what a further step y from the new place must keep
    std::uint32_t triangle = kNone;
    bool wound = false;  // the side touched is the one that the winding calls outside
  };
  // Moves from p by the step, as far as nothing is in the way.
  Sweep sweep(const Vec3& p, const Vec3& step);

 private:
  struct Face {
    TrianglePoints corners;
    Vec3 normal;
    std::uint32_t id;
  };
  static constexpr std::size_t kCapacity = 32;

  bool lookUp(const Vec3& p, const Vec3& step);
  bool lookUpAround(const Vec3& p, const Vec3& way);
  bool gather(const Box& box);
  // The share of the step that stays in the box looked up.
  double inside(const Vec3& p, const Vec3& step) const;
  std::size_t facesAhead(const Vec3& p, const Vec3& step, std::array<std::uint8_t, kCapacity>& ahead) const;
  void test(const Face& face, const Vec3& p, const Vec3& step, Sweep& best, double& crossing) const;

  const ContactSurface& m_surface;
  double m_skin;
  Vec3 m_expected;
  double m_reach = 0.0;
  Box m_box;
  std::array<Face, kCapacity> m_faces;
  std::size_t m_count = 0;
  bool m_crowded = false;
};

}  // namespace handwheel
