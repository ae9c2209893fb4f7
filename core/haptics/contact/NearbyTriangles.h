// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "haptics/contact/ContactPlanes.h"
#include "haptics/contact/ContactSurface.h"
#include "haptics/contact/FaceBoxes.h"

#include <array>
#include <optional>

namespace handwheel {

// Cache of the triangles near the proxy, for repeated sweep tests. They are looked up once and then tested many times,
// over several ticks. Servo thread; fixed memory.
class NearbyTriangles {
 public:
  // Begins a tick. expected: the predicted path of the proxy from its first position; the next look-up covers it, so
  // that one look-up is usually enough. Returns false if the surface is not that of the previous tick: then the cached
  // triangles are discarded. The surface must outlive the tick.
  bool begin(const ContactSurface& surface, const Vec3& expected);

  // Discards the cached triangles, so that the next sweeps do not depend on the ticks before.
  void forget();

  // Result of a sweep.
  struct Sweep {
    double fraction = 1.0;  // share of the step moved: up to the skin above the hit, or to the end of the cached region
    std::optional<HalfSpace> hit;  // the plane hit, as the constraint on a further step y from the new position
    TouchedFace face;              // its triangle
  };
  // Moves from p along the step until a triangle blocks it.
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
  enum class Test { Boxes, Triangles };  // boxes are tested faster, but those of slivers are large
  // Returns false if more triangles meet than there is room for.
  bool gather(Test test);
  // Returns the share of the step that stays in the cached box; 0 if it does not begin there.
  double inside(const Vec3& p, const Vec3& step) const;
  std::size_t facesAhead(const Vec3& p, const Vec3& step, std::array<std::uint8_t, kCapacity>& ahead) const;
  void test(const Face& face, const Vec3& p, const Vec3& step, Sweep& best, double& crossing) const;

  const ContactSurface* m_surface = nullptr;
  std::uint64_t m_version = 0;  // version of the surface that was looked up
  double m_skin = 0.0;
  Vec3 m_expected = Vec3::Zero();
  bool m_hasLooked = false;  // a look-up was made in this tick
  double m_reach = 0.0;
  double m_usualReach = 0.0;  // reach that finds a few triangles; 0: not known
  Box m_box;                  // the box that was looked up; it holds these faces
  std::array<Face, kCapacity> m_faces;
  FaceBoxes m_boxes;
  std::size_t m_count = 0;  // kCapacity + 1: too many, so each sweep finds its triangles itself
};

}  // namespace handwheel
