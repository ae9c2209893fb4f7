// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/MeshDelta.h"

#include <algorithm>

namespace handwheel {

namespace {

// Returns the end of the run that starts at this slot: after its length, or at the end of its page or of the common
// slots.
std::size_t endOfRun(std::size_t first, std::size_t runSlots, std::size_t common) {
  constexpr std::size_t page = PagedArray<Vec3>::kPageSize;
  return std::min({first + runSlots, (first / page + 1) * page, common});
}

template <class T>
bool areEqual(const PagedArray<T>& a, const PagedArray<T>& b) {
  if (a.size() != b.size()) return false;
  constexpr std::size_t page = PagedArray<T>::kPageSize;
  for (std::size_t start = 0; start < a.size(); start += page) {
    if (a.sharesPage(b, start / page)) continue;
    for (std::size_t i = start; i < std::min(start + page, a.size()); ++i)
      if (!(a[i] == b[i])) return false;
  }
  return true;
}

}  // namespace

template <class T>
template <class Self, class Visit>
void MeshDelta::Slots<T>::forEach(Self& self, std::size_t common, Visit visit) {
  std::size_t at = 0;
  for (std::size_t first : self.starts) {
    const std::size_t end = endOfRun(first, self.runSlots, common);
    for (std::size_t i = first; i < end; ++i) visit(i, self.values[at++]);
  }
}

template <class T>
MeshDelta::Slots<T> MeshDelta::difference(const PagedArray<T>& before, const PagedArray<T>& after,
                                          std::size_t runSlots) {
  Slots<T> slots;
  slots.size = after.size();
  slots.runSlots = runSlots;
  const std::size_t common = std::min(before.size(), after.size());
  constexpr std::size_t page = PagedArray<T>::kPageSize;
  for (std::size_t start = 0; start < common; start += page) {
    if (before.sharesPage(after, start / page)) continue;
    const std::size_t end = std::min(start + page, common);
    for (std::size_t i = start; i < end;) {
      const std::size_t runEnd = endOfRun(i, runSlots, common);
      std::size_t k = i;
      while (k < runEnd && before[k] == after[k]) ++k;
      if (k < runEnd) {
        slots.starts.push_back(static_cast<std::uint32_t>(i));
        for (k = i; k < runEnd; ++k) slots.values.push_back(after[k]);
      }
      i = runEnd;
    }
  }
  for (std::size_t i = common; i < after.size(); ++i) slots.tail.push_back(after[i]);
  slots.starts.shrink_to_fit();
  slots.values.shrink_to_fit();
  slots.tail.shrink_to_fit();
  return slots;
}

template <class T>
void MeshDelta::swapSlots(PagedArray<T>& array, Slots<T>& slots) {
  Slots<T>::forEach(slots, std::min(array.size(), slots.size), [&](std::size_t i, T& value) {
    const T old = array[i];
    if (old == value) return;  // keeps the page shared
    array.set(i, value);
    value = old;
  });
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

bool MeshDelta::isEmptyBetween(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  return areEqual(before.m_positions, after.m_positions) && areEqual(before.m_faces, after.m_faces);
}

MeshDelta MeshDelta::between(const HalfEdgeMesh& before, const HalfEdgeMesh& after, std::size_t runSlots) {
  MeshDelta delta;
  delta.m_positions = difference(before.m_positions, after.m_positions, runSlots);
  delta.m_faces = difference(before.m_faces, after.m_faces, runSlots);
  delta.m_isEmpty = delta.m_positions.values.empty() && delta.m_faces.values.empty() &&
                    before.vertexSlots() == after.vertexSlots() && before.faceSlots() == after.faceSlots();
  return delta;
}

void MeshDelta::swap(HalfEdgeMesh& mesh) {
  swapSlots(mesh.m_positions, m_positions);
  const auto liveFaces = [this] {
    const auto countIn = [](const std::vector<HalfEdgeMesh::FaceSlot>& slots) {
      return std::count_if(slots.begin(), slots.end(), [](const auto& slot) { return slot.isLive(); });
    };
    return static_cast<std::size_t>(countIn(m_faces.values) + countIn(m_faces.tail));
  };
  mesh.m_liveFaces += liveFaces();
  swapSlots(mesh.m_faces, m_faces);
  mesh.m_liveFaces -= liveFaces();
}

std::size_t MeshDelta::bytes() const {
  const auto of = [](const auto& slots) {
    return slots.starts.capacity() * sizeof(slots.starts[0]) + slots.values.capacity() * sizeof(slots.values[0]) +
           slots.tail.capacity() * sizeof(slots.tail[0]);
  };
  return sizeof(*this) + of(m_positions) + of(m_faces);
}

std::vector<Face> MeshDelta::touchedFaces(const HalfEdgeMesh& mesh) const {
  std::vector<Face> faces;
  const std::size_t common = std::min(m_faces.size, mesh.faceSlots());
  const std::size_t end = std::max(m_faces.size, mesh.faceSlots());
  Slots<HalfEdgeMesh::FaceSlot>::forEach(m_faces, common, [&](std::size_t f, const HalfEdgeMesh::FaceSlot& slot) {
    if (!(mesh.m_faces[f] == slot)) faces.push_back(static_cast<Face>(f));
  });
  for (std::size_t f = common; f < end; ++f) faces.push_back(static_cast<Face>(f));
  if (m_positions.values.empty()) return faces;

  std::vector<bool> moved(mesh.vertexSlots(), false);
  Slots<Vec3>::forEach(m_positions, std::min(m_positions.size, mesh.vertexSlots()),
                       [&](std::size_t v, const Vec3& p) { moved[v] = mesh.position(static_cast<Vertex>(v)) != p; });
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const Triangle& t = mesh.triangle(f);
    if (moved[t[0]] || moved[t[1]] || moved[t[2]]) faces.push_back(f);
  }
  return faces;
}

}  // namespace handwheel
