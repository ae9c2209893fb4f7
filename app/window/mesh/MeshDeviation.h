// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/Deviation.h"
#include "viewport/ColourScale.h"

#include <QString>

namespace handwheel {

// What an open mesh was compared with, and how far it is from that. Holds for one revision of the document.
struct MeshDeviation {
  QString file;               // that it was compared with; empty: the mesh as it was opened
  std::uint64_t changes = 0;  // OpenMesh::changes of the mesh that was compared
  Deviation figures;
  VertexValues atVertex;  // of figures.ofMesh, which has none itself
  std::shared_ptr<const SurfaceDistance> scan;
  double diagonal = 0.0;  // mm, of the scan
  ColourScale scale;

  const SurfaceDeviation& ofMesh() const { return figures.ofMesh; }
};

// The share of the area in bins equally wide from -range to range; what lies beyond is in those at the ends.
std::vector<double> sharesWithin(const SurfaceDeviation& deviation, double range, std::size_t bins);

}  // namespace handwheel
