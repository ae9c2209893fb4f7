// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ContactHierarchy.h"

namespace handwheel {

ContactHierarchy::ContactHierarchy(std::vector<ContactTriangle> triangles, Progress progress) {
  std::erase_if(triangles, [](const ContactTriangle& t) {
    return !t.corners[0].allFinite() || !t.corners[1].allFinite() || !t.corners[2].allFinite();
  });
  std::vector<Vec3> middles;  // enough to know where the model is
  middles.reserve(triangles.size());
  for (const ContactTriangle& t : triangles) middles.push_back(t.corners[0]);
  m_frame = BoxFrame(middles);
  std::vector<BoxedItem> items(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto& [a, b, c] = triangles[i].corners;
    items[i].box = m_frame.around(a, b, c);
    items[i].setId(static_cast<std::uint32_t>(i));
  }
  if (!m_tree.build(items, progress)) return;
  m_triangles.reserve(items.size());
  for (const BoxedItem& item : items) {
    m_triangles.push_back(triangles[item.id()]);
    for (const Vec3& corner : m_triangles.back().corners) m_bounds.extend(corner);
  }
}

}  // namespace handwheel
