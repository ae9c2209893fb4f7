// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/boundary/BoundaryPick.h"
#include "mesh/boundary/FaceJoining.h"
#include "tools/mesh/MeshServices.h"

#include <optional>

namespace handwheel {

// Returns the message for a problem: English text, translated in the context "Property". It is empty if there is no
// problem.
const char* textOf(JoinProblem problem);
// Returns the hint about the effect of releasing the button: English text, translated in the context "Tool". If there
// is a problem, the hint is the reason why releasing has no effect; otherwise it is `otherwise`.
const char* hintOf(JoinProblem problem, const char* otherwise);

// The reason why a change of an edge may have no effect; English text, translated in the context "Tool".
extern const char* const kEdgeChanged;

// Picks points and loops on the boundaries of a document's mesh. Queries refer to the present mesh, even while the face
// hierarchy is still that of an older mesh.
class BoundaryPicking {
 public:
  BoundaryPicking(const MeshDocument& document, const MeshServices& services)
      : m_document(document), m_faces(services.faces) {}

  // Returns a point of a loop within reach; points at the position "without" are ignored.
  std::optional<BoundaryPoint> pointAt(const PickRay& pickRay, const std::optional<Vec3>& without = {}) const;
  // Returns the key of the loop under the pointer.
  std::optional<Vertex> loopAt(const PickRay& pickRay) const;
  // Returns the locator of faces near a position, or null if no hierarchy has been built yet. The result is valid until
  // the document changes.
  std::shared_ptr<const FaceLocator> near();

 private:
  const MeshDocument& m_document;
  std::function<std::shared_ptr<const FaceHierarchy>()> m_faces;
  std::shared_ptr<const FaceHierarchy> m_older;
  std::shared_ptr<const FaceLocator> m_near;
  std::uint64_t m_revision = 0;
};

}  // namespace handwheel
