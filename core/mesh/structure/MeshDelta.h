// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// The difference between two versions of a mesh. Memory is proportional to the change; finding it costs time in
// proportion to the pages that the change touched.
class MeshDelta {
 public:
  // The number of slots per run. Runs start at the first slot of a page; a run is stored completely if one of its slots
  // differs. Single slots take the least memory, longer runs less time. The setting document.undo_granularity.
  static constexpr std::size_t kRunSlots = 1;
  static MeshDelta between(const HalfEdgeMesh& before, const HalfEdgeMesh& after, std::size_t runSlots = kRunSlots);

  // Returns true if two versions are equal, slot for slot. Stops at the first difference. O(pages + equal pages not
  // shared).
  static bool isEmptyBetween(const HalfEdgeMesh& before, const HalfEdgeMesh& after);

  // Turns "before" into "after" and this delta into its own inverse, so that applying it again undoes it.
  void swap(HalfEdgeMesh& mesh);

  bool isEmpty() const { return m_isEmpty; }
  std::size_t bytes() const;
  // Returns the faces whose appearance the next swap() of this mesh will change, to redraw only them. A face may be
  // listed twice.
  std::vector<Face> touchedFaces(const HalfEdgeMesh& mesh) const;

 private:
  template <class T>
  struct Slots {
    std::size_t size = 0;               // number of slots after the swap
    std::size_t runSlots = 1;           // the last run of a page, or before the smaller size, may be shorter
    std::vector<std::uint32_t> starts;  // first slot of each run, ascending; all below both sizes
    std::vector<T> values;              // values of the runs, one after the other
    std::vector<T> tail;                // slots beyond the smaller size

    // Calls visit(slot, value) for each slot of the runs.
    template <class Self, class Visit>
    static void forEach(Self& self, std::size_t common, Visit visit);
  };
  template <class T>
  static Slots<T> difference(const PagedArray<T>& before, const PagedArray<T>& after, std::size_t runSlots);
  template <class T>
  static void swapSlots(PagedArray<T>& array, Slots<T>& slots);

  Slots<Vec3> m_positions;
  Slots<HalfEdgeMesh::FaceSlot> m_faces;
  bool m_isEmpty = true;
};

}  // namespace handwheel
