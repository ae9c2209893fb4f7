// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/TouchableSurface.h"

#include "haptics/contact/ContactGaps.h"

#include <cassert>

namespace handwheel {

ContactSurface touchableSurface(std::vector<Vec3> points, std::vector<Triangle> triangles,
                                std::span<const std::uint32_t> faces, Progress progress) {
  const std::size_t count = triangles.size();
  assert(faces.empty() || faces.size() == count);
  closeContactGaps(points, triangles, progress.part(0.0, 0.3));
  if (progress.cancelled()) return {};
  std::vector<ContactTriangle> all;
  all.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i];
    const auto index = static_cast<std::uint32_t>(i);
    const std::uint32_t number =
        i >= count ? 2 * static_cast<std::uint32_t>(i - count) + 1 : touchableNumber(faces.empty() ? index : faces[i]);
    all.push_back({{points[a], points[b], points[c]}, number});
  }
  return ContactSurface(std::move(all), progress.part(0.3, 1.0));
}

}  // namespace handwheel
