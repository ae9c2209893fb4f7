// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/HalfEdgeMesh.h"

#include <vector>

namespace handwheel {

// The difference between two versions of a mesh. Memory is proportional to the change; the time to find it is
// proportional to the number of pages that the change touched.
class MeshDelta {
 public:
  // The number of slots per run (the setting document.undo_granularity). Runs start at the first slot of a page; a run
  // is stored completely if one of its slots differs. Single slots take the least memory; longer runs take less time.
  static constexpr std::size_t kRunSlots = 1;
  static MeshDelta between(const HalfEdgeMesh& before, const HalfEdgeMesh& after, std::size_t runSlots = kRunSlots);

  // Returns true if two versions are equal, slot for slot. Stops at the first difference. O(pages) plus the time to
  // compare pages that are not shared.
  static bool isEmptyBetween(const HalfEdgeMesh& before, const HalfEdgeMesh& after);

  // Turns the version "before" into "after" and this delta into its own inverse, so that applying it again undoes it.
  void swap(HalfEdgeMesh& mesh);

  bool isEmpty() const { return m_isEmpty; }
  std::size_t bytes() const;
  // Returns the faces whose appearance the next swap() of this mesh will change, so that only these are redrawn. A face
  // may be listed twice.
  std::vector<Face> touchedFaces(const HalfEdgeMesh& mesh) const;

 private:
  template <class T>
  struct Slots {
    std::size_t size = 0;  // number of slots after the swap
    // Number of slots per run. The last run of a page, or of the slots that both versions have, may be shorter.
    std::size_t runSlots = 1;
    std::vector<std::uint32_t> starts;  // first slot of each run, ascending; both versions have it
    std::vector<T> values;              // values of the runs, one after the other
    std::vector<T> tail;                // slots that only the larger version has

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
