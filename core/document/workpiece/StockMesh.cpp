// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/StockMesh.h"

#include "nurbs/Tessellation.h"

#include <cassert>

namespace handwheel {

StockMesh::StockMesh(const StockCylinder& stock, double chord) : m_stock(stock), m_chord(chord) {
  m_stock.position = 0.0;
}

bool StockMesh::isOf(const StockCylinder& stock, double chord) const {
  return stock.diameter == m_stock.diameter && stock.length == m_stock.length && chord == m_chord;
}

std::shared_ptr<const TriangleSoup> StockMesh::soup() const {
  std::call_once(m_made, [this] {
    TessellationOptions options;
    options.chord = m_chord;
    Result<TriangleSoup> made = tessellate(m_stock.profile(), options);
    assert(made);  // the limits see to that
    m_soup = std::make_shared<const TriangleSoup>(std::move(made.value()));
  });
  return m_soup;
}

}  // namespace handwheel
