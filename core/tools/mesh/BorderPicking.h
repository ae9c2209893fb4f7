// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/BorderPick.h"
#include "mesh/FaceJoining.h"
#include "tools/mesh/MeshServices.h"

#include <optional>

namespace handwheel {

// The sentence for a problem: English, context "Property"; empty for none.
const char* textOf(JoinProblem problem);
// What letting go does: nothing, and why, or what it would do otherwise. English, context "Tool".
const char* hintOf(JoinProblem problem, const char* otherwise);

// Why a change of an edge may come to nothing; English, context "Tool".
extern const char* const kEdgeChanged;

// What a pointer points at on the borders of a document's mesh. Queries are about the present mesh, even while its
// hierarchy is still that of an older one.
class BorderPicking {
 public:
  BorderPicking(const MeshDocument& document, const MeshServices& services)
      : m_document(document), m_faces(services.faces) {}

  // A point of a loop within reach; points at the position "without" do not count.
  std::optional<BorderPoint> pointAt(const Sight& sight, const std::optional<Vec3>& without = {}) const;
  // The loop that one points at, by its key.
  std::optional<Vertex> loopAt(const Sight& sight) const;
  // Null until the first hierarchy is there. The answer holds until the document changes.
  std::shared_ptr<const NearFaces> near();

 private:
  const MeshDocument& m_document;
  std::function<std::shared_ptr<const FaceHierarchy>()> m_faces;
  std::shared_ptr<const FaceHierarchy> m_older;
  std::shared_ptr<const NearFaces> m_near;
  std::uint64_t m_revision = 0;
};

}  // namespace handwheel
