// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/defects/Defects.h"

namespace handwheel {

// Difference between the defect lists of two versions of a mesh. The undo history stores it instead of a copy of the
// lists for each step. A local edit changes one contiguous range of each list.
class DefectsDelta {
 public:
  // Returns the difference between two lists. O(defects).
  static DefectsDelta between(const Defects& before, const Defects& after);

  // Turns "before" into "after" and this delta into its own inverse. O(defects).
  void swap(Defects& defects);

  std::size_t bytes() const;

 private:
  // The elements of the other version between the common beginning and the common end of a list.
  template <class T>
  struct Stretch {
    std::size_t begin = 0;
    std::size_t behind = 0;  // number of elements in the common end
    std::vector<T> other;
  };
  template <class T, class Same>
  static Stretch<T> stretch(const std::vector<T>& before, const std::vector<T>& after, Same same);
  template <class T>
  static void swapStretch(std::vector<T>& list, Stretch<T>& stretch);

  Stretch<BoundaryLoop> m_loops;
  Stretch<std::pair<Vertex, Vertex>> m_nonManifoldEdges;
  Stretch<Vertex> m_nonManifoldVertices;
  Stretch<std::pair<Vertex, Vertex>> m_nonOrientableEdges;
  Stretch<Face> m_inconsistentFaces;
  Stretch<std::vector<Face>> m_insideOut;
  Stretch<Face> m_degenerateFaces;
  Stretch<Face> m_duplicateFaces;
  Stretch<std::pair<Vertex, Vertex>> m_nearVertices;
  Stretch<Component> m_components;
  std::size_t m_nestedBodies = 0;
  Box m_box;
};

}  // namespace handwheel
