// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/MeshDelta.h"

#include <algorithm>

namespace handwheel {

template <class T>
MeshDelta::Slots<T> MeshDelta::difference(const PagedArray<T>& before, const PagedArray<T>& after) {
  Slots<T> slots;
  slots.size = after.size();
  const std::size_t common = std::min(before.size(), after.size());
  constexpr std::size_t page = PagedArray<T>::kPageSize;
  for (std::size_t start = 0; start < common; start += page) {
    if (before.sharesPage(after, start / page)) continue;
    const std::size_t end = std::min(start + page, common);
    for (std::size_t i = start; i < end; ++i) {
      if (!(before[i] == after[i])) slots.values.emplace_back(static_cast<std::uint32_t>(i), after[i]);
    }
  }
  for (std::size_t i = common; i < after.size(); ++i) slots.tail.push_back(after[i]);
  return slots;
}

template <class T>
void MeshDelta::swapSlots(PagedArray<T>& array, Slots<T>& slots) {
  for (auto& [i, value] : slots.values) {
    const T old = array[i];
    array.set(i, value);
    value = old;
  }
  const std::size_t oldSize = array.size();
  if (slots.size < oldSize) {  // shrink; keep what is cut off
    for (std::size_t i = slots.size; i < oldSize; ++i) slots.tail.push_back(array[i]);
    array.truncate(slots.size);
  } else {
    for (const T& value : slots.tail) array.push_back(value);
    slots.tail.clear();
    slots.tail.shrink_to_fit();
  }
  slots.size = oldSize;
}

MeshDelta MeshDelta::between(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  MeshDelta delta;
  delta.m_positions = difference(before.m_positions, after.m_positions);
  delta.m_faces = difference(before.m_faces, after.m_faces);
  delta.m_isEmpty = delta.m_positions.values.empty() && delta.m_faces.values.empty() &&
                    before.vertexSlots() == after.vertexSlots() && before.faceSlots() == after.faceSlots();
  return delta;
}

void MeshDelta::swap(HalfEdgeMesh& mesh) {
  swapSlots(mesh.m_positions, m_positions);
  swapSlots(mesh.m_faces, m_faces);
}

std::size_t MeshDelta::bytes() const {
  const auto of = [](const auto& slots) {
    return slots.values.capacity() * sizeof(slots.values[0]) + slots.tail.capacity() * sizeof(slots.tail[0]);
  };
  return sizeof(*this) + of(m_positions) + of(m_faces);
}

std::vector<Face> MeshDelta::touchedFaces(const HalfEdgeMesh& mesh) const {
  std::vector<Face> faces;
  for (const auto& entry : m_faces.values) faces.push_back(entry.first);
  const std::size_t common = std::min(m_faces.size, mesh.faceSlots());
  const std::size_t end = std::max(m_faces.size, mesh.faceSlots());
  for (std::size_t f = common; f < end; ++f) faces.push_back(static_cast<Face>(f));
  if (m_positions.values.empty()) return faces;

  std::vector<bool> moved(mesh.vertexSlots(), false);
  for (const auto& entry : m_positions.values) moved[entry.first] = true;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const Triangle& t = mesh.triangle(f);
    if (moved[t[0]] || moved[t[1]] || moved[t[2]]) faces.push_back(f);
  }
  return faces;
}

}  // namespace handwheel
