// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/HalfEdgeMesh.h"

#include <utility>
#include <vector>

namespace handwheel {

// What differs between two versions of a mesh, slot by slot. Memory is proportional to the change; finding it costs
// time in proportion to the pages that the change touched.
class MeshDelta {
 public:
  static MeshDelta between(const HalfEdgeMesh& before, const HalfEdgeMesh& after);

  // Turns "before" into "after" and this delta into its own inverse, so that applying it again undoes it.
  void swap(HalfEdgeMesh& mesh);

  bool isEmpty() const { return m_isEmpty; }
  std::size_t bytes() const;
  // Faces whose looks the next swap() of this mesh will change; for redrawing only them. May name a face twice.
  std::vector<Face> touchedFaces(const HalfEdgeMesh& mesh) const;

 private:
  template <class T>
  struct Slots {
    std::size_t size = 0;                             // number of slots after the swap
    std::vector<std::pair<std::uint32_t, T>> values;  // slots below both sizes
    std::vector<T> tail;                              // slots beyond the smaller size
  };
  template <class T>
  static Slots<T> difference(const PagedArray<T>& before, const PagedArray<T>& after);
  template <class T>
  static void swapSlots(PagedArray<T>& array, Slots<T>& slots);

  Slots<Vec3> m_positions;
  Slots<HalfEdgeMesh::FaceSlot> m_faces;
  bool m_isEmpty = true;
};

}  // namespace handwheel
