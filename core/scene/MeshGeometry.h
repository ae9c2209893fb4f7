// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/BodyGeometry.h"

namespace handwheel {

// The shape of a body as triangles, such as a scan or an imported part.
class MeshGeometry : public BodyGeometry {
 public:
  static constexpr std::string_view kKind = "mesh";
  // Largest absolute coordinate, mm.
  static constexpr double kLargestCoordinate = 1e9;

  // Every coordinate must be finite and within kLargestCoordinate, and every index within range.
  explicit MeshGeometry(TriangleSoup soup);

  const TriangleSoup& soup() const { return *m_soup; }

  std::string_view kind() const override { return kKind; }
  std::size_t bytes() const override;

 protected:
  std::shared_ptr<const TriangleSoup> makeSurface() const override { return m_soup; }

 private:
  std::shared_ptr<const TriangleSoup> m_soup;
};

// Returns true if a soup is not empty and the constructor accepts it. O(points + triangles).
bool isSoundSoup(const TriangleSoup& soup);

}  // namespace handwheel
