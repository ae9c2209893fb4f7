// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/cell/BodyPlacing.h"

#include "document/cell/BodyCarriers.h"
#include "document/cell/CellDisplay.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

double sizeOf(const Box& box) {
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

bool overlaps(const Box& one, const Box& other) {
  constexpr double kTouching = 1e-3;  // mm: what stands on something is not inside it
  const Box common = one.intersection(other);
  return !common.isEmpty() && common.sizes().minCoeff() > kTouching;
}

}  // namespace

Box boundsOf(const Body& body) {
  Box bounds;
  const Box& own = body.geometry->bounds();
  if (own.isEmpty()) return bounds;
  for (int corner = 0; corner < 8; ++corner)
    bounds.extend(body.pose * own.corner(static_cast<Box::CornerType>(corner)));
  return bounds;
}

Vec3 displacementBeside(const Box& own, const Box& robots, const RobotCellSnapshot& cell, std::optional<BodyId> but) {
  Box there = robots;
  for (const BodyPointer& body : inFrameOfBase(cell.bodies, cell.robot->model, cell.joints)) {
    if (body->id != but) there.extend(boundsOf(*body));
  }
  const double x = there.isEmpty() ? 0.0 : std::ceil(there.max().x() - own.min().x());
  return {x, 0.0 - own.center().y(), 0.0 - own.min().z()};
}

bool isInsideOthers(const Box& own, const Box& robots, const RobotCellSnapshot& cell) {
  const double largest = robots.isEmpty() ? std::numeric_limits<double>::infinity() : sizeOf(robots);
  if (own.isEmpty() || !(sizeOf(own) <= largest)) return false;
  const DisplayModel links = displayOf(*cell.robot, cell.joints);
  const bool isInLink = std::any_of(links.parts.begin(), links.parts.end(), [&](const DisplayPart& part) {
    return overlaps(own, DisplayModel{{part}}.bounds());
  });
  const BodySet bodies = inFrameOfBase(cell.bodies, cell.robot->model, cell.joints);
  return isInLink || std::any_of(bodies.begin(), bodies.end(), [&](const BodyPointer& body) {
           const Box box = boundsOf(*body);
           return sizeOf(box) <= largest && overlaps(own, box);
         });
}

}  // namespace handwheel
