// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BoundaryLoops.h"
#include "mesh/FaceSelection.h"

#include <set>
#include <span>
#include <vector>

namespace handwheel {

// The loop whose keyOf() this is; null when there is none. O(all loops).
const BoundaryLoop* loopWithKey(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> loops, Vertex key);

// The line of a loop, closed.
std::vector<Vec3> outlineOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop);

// The lines that part the faces from the others and from nothing, closed. O(faces).
std::vector<std::vector<Vec3>> outlinesOf(const HalfEdgeMesh& mesh, const FaceSelection& faces);

// What is selected of a mesh: faces, and loops by their keys.
struct MeshSelection {
  FaceSelection faces;
  std::set<Vertex> loops;

  bool empty() const { return faces.empty() && loops.empty(); }
  void add(const MeshSelection& other);
  void remove(const MeshSelection& other);
  // Takes out what is no longer there.
  void dropDead(const HalfEdgeMesh& mesh, std::span<const BoundaryLoop> present);

  bool operator==(const MeshSelection&) const = default;
};

// The selections of one session, to go back to. Selecting is no edit of the document, so it has a small history of its
// own.
class SelectionSteps {
 public:
  explicit SelectionSteps(MeshSelection first) { m_steps.push_back(std::move(first)); }

  const MeshSelection& present() const { return m_steps[m_at]; }
  // A new step, unless it selects the same.
  void change(MeshSelection selection);
  // Not a step: part of it is no longer there.
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
