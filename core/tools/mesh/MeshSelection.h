// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/selection/FaceSelection.h"

#include <set>
#include <span>
#include <vector>

namespace handwheel {

// Finds a loop by its key (keyOf()). Returns null if there is none. O(all loops).
const BoundaryLoop* loopWithKey(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, Vertex key);

// Returns the closed polyline of a boundary loop.
std::vector<Vec3> outlineOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

// Returns the closed polylines around a set of faces. They separate the faces from others and run along open edges.
// O(faces).
std::vector<std::vector<Vec3>> outlinesOf(const HalfEdgeMesh& mesh, const FaceSelection& faces);

// Selected faces and boundary loops of a mesh. Loops are stored by their keys.
struct MeshSelection {
  FaceSelection faces;
  std::set<Vertex> loops;

  bool empty() const { return faces.empty() && loops.empty(); }
  void add(const MeshSelection& other);
  void remove(const MeshSelection& other);
  // Removes faces and loops that no longer exist.
  void dropDead(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> present);

  bool operator==(const MeshSelection&) const = default;
};

// The undo history of the selection during a session. Selecting is not an edit of the document, so the selection has
// its own history.
class SelectionHistory {
 public:
  explicit SelectionHistory(MeshSelection first) { m_steps.push_back(std::move(first)); }

  const MeshSelection& present() const { return m_steps[m_at]; }
  // Adds a step, unless the selection is the same as the present one.
  void change(MeshSelection selection);
  // Replaces the present selection without a step, because part of it no longer exists.
  void replacePresent(MeshSelection selection) { m_steps[m_at] = std::move(selection); }

  bool canGoBack() const { return m_at > 0; }
  bool canGoForward() const { return m_at + 1 < m_steps.size(); }
  void goBack() { m_at -= canGoBack(); }
  void goForward() { m_at += canGoForward(); }

 private:
  static constexpr std::size_t kMostSteps = 100;

  std::vector<MeshSelection> m_steps;  // never empty
  std::size_t m_at = 0;
};

}  // namespace handwheel
