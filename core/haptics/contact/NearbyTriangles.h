// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactPlanes.h"
#include "haptics/contact/ContactSurface.h"
#include "haptics/contact/FaceBoxes.h"

#include <array>
#include <optional>

namespace handwheel {

// Cache of the triangles near the proxy, for repeated sweep tests. The triangles are looked up once and then tested
// many times, over several ticks. The cache is used on the servo thread, and takes a fixed amount of memory.
class NearbyTriangles {
 public:
  // Begins a tick. expected: the predicted path of the proxy from its first position. The next look-up covers this
  // path, so that one look-up is usually enough. Returns false if the surface differs from that of the previous tick,
  // in which case the cached triangles are discarded. The surface must outlive the tick.
  bool begin(const ContactSurface& surface, const Vec3& expected);

  // Discards the cached triangles, so that the next sweeps do not depend on earlier ticks.
  void forget();

  // Result of a sweep.
  struct Sweep {
    // Fraction of the step that was moved, up to the skin distance from the hit, or to the end of the cached region.
    double fraction = 1.0;
    std::optional<HalfSpace> hit;  // the plane hit, as a constraint on a further step y from the new position
    TouchedFace face;              // the triangle hit
  };
  // Moves a point from p along the step until a triangle blocks it, or until it reaches the end of the cached region.
  Sweep sweep(const Vec3& p, const Vec3& step);

  // Sets the look-ahead distance for the rest of the tick, mm.
  void setReach(double reach) { m_reach = reach; }
  double reach() const { return m_reach; }

 private:
  struct Face {
    TrianglePoints corners;
    Vec3 normal;
  };
  static constexpr std::size_t kCapacity = FaceBoxes::kCapacity;

  void lookUpAround(const Vec3& p, const Vec3& displacement);
  enum class Test { Boxes, Triangles };  // the test of boxes is faster, but slivers have large boxes
  // Stores the triangles that meet the cached region. Returns false if there are more than the cache can hold.
  bool gather(Test test);
  // Returns the fraction of the step that is in the cached box, or 0 if the step does not begin in the box.
  double inside(const Vec3& p, const Vec3& step) const;
  std::size_t facesAhead(const Vec3& p, const Vec3& step, std::array<std::uint8_t, kCapacity>& ahead) const;
  void test(const Face& face, const Vec3& p, const Vec3& step, Sweep& best, double& crossing) const;

  const ContactSurface* m_surface = nullptr;
  std::uint64_t m_version = 0;  // version of the surface that was looked up
  double m_skin = 0.0;
  Vec3 m_expected = Vec3::Zero();
  bool m_hasLooked = false;  // a look-up was made in this tick
  double m_reach = 0.0;
  double m_usualReach = 0.0;  // reach that finds a few triangles; 0: unknown
  Box m_box;                  // the box that was looked up, which contains the cached faces
  std::array<Face, kCapacity> m_faces;
  FaceBoxes m_boxes;
  std::size_t m_count = 0;  // kCapacity + 1: too many faces, so that each sweep looks up its triangles itself
};

}  // namespace handwheel
