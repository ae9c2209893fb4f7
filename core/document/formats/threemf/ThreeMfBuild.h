// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/formats/MeshAssembly.h"
#include "document/formats/threemf/ThreeMfModel.h"

#include <functional>
#include <set>

namespace handwheel {

// The assembly of the objects of a 3MF file according to its build section. As the result of a small file may be huge
// or endless, it is counted first. It is rejected if it has more than 2^25 triangles or points, more than 100 nested
// components, or a cycle.
class ThreeMfBuild {
 public:
  // A function that returns the part with the path in a reference, or null.
  using FindPart = std::function<const ThreeMfPart*(const std::string& path)>;

  ThreeMfBuild(FindPart findPart, MeshAssembly& assembly) : m_findPart(std::move(findPart)), m_assembly(assembly) {}

  // Adds the triangles of the root part's items to the assembly. withoutBuild: the build section is lost, and every
  // object that is not a component of another is built. Returns false if reading must end; the assembly has the reason.
  bool build(const ThreeMfPart& root, bool withoutBuild);

 private:
  struct Size {
    std::uint64_t points = 0, triangles = 0;
    int height = 0;  // depth of nested components
    bool isCounting = false;
  };
  struct Target {
    const ThreeMfPart* part = nullptr;
    const ThreeMfObject* object = nullptr;
  };

  Target target(const ThreeMfPart& part, const ThreeMfReference& reference) const;
  bool count(const ThreeMfPart& part, const ThreeMfReference& reference, int depth, Size& outer);
  bool add(const ThreeMfPart& part, const ThreeMfReference& reference, const ThreeMfTransform& outer);
  bool addMesh(const TriangleSoup& mesh, const ThreeMfTransform& transform);

  FindPart m_findPart;
  MeshAssembly& m_assembly;
  std::map<const ThreeMfObject*, Size> m_sizes;
  std::set<const ThreeMfReference*> m_broken;  // references with damage that was tolerated
};

}  // namespace handwheel
