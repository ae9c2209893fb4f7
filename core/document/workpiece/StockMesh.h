// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/structure/TriangleSoup.h"
#include "nurbs/StockCylinder.h"

#include <memory>
#include <mutex>

namespace handwheel {

// The triangles of a cylindrical bar, computed on first use. The bar begins at z = 0. Versions of a document share the
// triangles unless the bar or its chord tolerance differs. An object can be used on any thread.
class StockMesh {
 public:
  // The stock must be valid, and the chord tolerance (mm) within the limits of WorkpieceSnapshot.
  StockMesh(const StockCylinder& stock, double chord);

  // Returns true if this is the mesh of such a bar; its position along the axis does not matter.
  bool isOf(const StockCylinder& stock, double chord) const;
  std::shared_ptr<const TriangleSoup> soup() const;

 private:
  StockCylinder m_stock;
  double m_chord;
  mutable std::once_flag m_made;
  mutable std::shared_ptr<const TriangleSoup> m_soup;
};

}  // namespace handwheel
