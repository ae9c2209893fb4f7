// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/search/PickRay.h"

#include <array>
#include <optional>
#include <vector>

namespace handwheel {

// The handles that translate and rotate an object. There is an arrow and a ring for each axis.
struct PlacingHandles {
  struct Handle {
    int axis = 0;  // 0…2
    bool isRing = false;
    bool operator==(const Handle&) const = default;
  };

  Vec3 centre = Vec3::Zero();                                             // mm
  std::array<Vec3, 3> axes{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};  // Unit vectors at right angles
  double length = 100.0;  // mm, length of the arrows, which reach beyond the rings

  double ringRadius() const { return 0.75 * length; }  // mm
  // Returns the handle within `pixels` logical pixels of the ray. Arrows take precedence over rings, because a ring
  // looks like a line from some sides. Of several handles of a kind, the one nearest to the viewer is returned.
  std::optional<Handle> under(const PickRay& pickRay, double pixels) const;
  // Returns the handle within this distance (mm) of a point.
  std::optional<Handle> near(const Vec3& position, double distance) const;
  // Returns the lines of a handle as they are drawn.
  std::vector<std::vector<Vec3>> linesOf(const Handle& handle) const;
  std::array<Handle, 6> all() const;

 private:
  std::vector<Vec3> outlineOf(const Handle& handle) const;
};

}  // namespace handwheel
