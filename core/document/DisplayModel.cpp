// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/DisplayModel.h"

namespace handwheel {

Box DisplayModel::bounds() const {
  Box box;
  for (const DisplayPart& part : parts) {
    for (const Vec3& p : part.soup->points) box.extend(part.pose * p);
  }
  return box;
}

TriangleSoup placedSoup(const DisplayModel& model) {
  TriangleSoup all;
  for (const DisplayPart& part : model.parts) {
    const auto base = static_cast<std::uint32_t>(all.points.size());
    for (const Vec3& p : part.soup->points) all.points.push_back(part.pose * p);
    for (const Triangle& t : part.soup->triangles) all.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  }
  return all;
}

}  // namespace handwheel
