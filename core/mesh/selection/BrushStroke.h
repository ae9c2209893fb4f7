// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/FaceHierarchy.h"

#include <memory>
#include <span>

namespace handwheel {

// A brush stroke: a ball moved over the surface that paints faces. Only faces connected inside the ball with the point
// under the pointer are painted, so the far side of a thin wall is not. Between two events the ball follows the surface
// along the path of the pointer, without gaps.
class BrushStroke {
 public:
  explicit BrushStroke(std::shared_ptr<const FaceHierarchy> faces);

  struct Touch {
    Ray ray;
    double radius = 0.0;  // radius of the ball, mm
  };
  // Paints along the path to the next pointer position. Returns the newly painted faces, in a list that the next call
  // overwrites. O(faces met), plus O(log n) for each half radius of the path.
  std::span<const Face> moveTo(const Touch& touch);

  const FaceHierarchy& faces() const { return *m_faces; }
  // Returns the last hit of the pointer on the surface.
  const std::optional<FaceHierarchy::Hit>& lastHit() const { return m_lastHit; }

 private:
  using Met = std::optional<FaceHierarchy::Hit>;
  void paintBetween(const Touch& from, const Met& a, const Touch& to, const Met& b, int depth);
  void paintAlong(std::span<const FaceHierarchy::Hit> ends, double radius);
  int halvings(const Touch& from, const Touch& to) const;

  std::shared_ptr<const FaceHierarchy> m_faces;
  std::optional<Touch> m_touch;
  Met m_lastHit;
  // Per face: the mark kPainted, and the number of the last capsule that met it. A capsule is the space that the ball
  // covers on a straight piece of the path.
  std::vector<std::uint32_t> m_marks;
  std::uint32_t m_capsule = 0;
  std::vector<Face> m_new;
  std::vector<Face> m_waiting;
};

}  // namespace handwheel
