// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/TriangleSoup.h"
#include "nurbs/StockCylinder.h"

#include <memory>
#include <mutex>

namespace handwheel {

// The triangles of a bar that begins at z = 0, made when somebody first asks: versions of a document that differ in
// other things share them. Any thread.
class StockMesh {
 public:
  // The stock is sound, the chord tolerance (mm) within the limits of WorkpieceSnapshot.
  StockMesh(const StockCylinder& stock, double chord);

  bool isOf(const StockCylinder& stock, double chord) const;  // wherever they stand along the axis
  std::shared_ptr<const TriangleSoup> soup() const;

 private:
  StockCylinder m_stock;
  double m_chord;
  mutable std::once_flag m_made;
  mutable std::shared_ptr<const TriangleSoup> m_soup;
};

}  // namespace handwheel
