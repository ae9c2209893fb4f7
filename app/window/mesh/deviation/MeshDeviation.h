// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/measure/Deviation.h"
#include "viewport/overlay/ColourScale.h"

#include <QString>

namespace handwheel {

// The result of comparing an open mesh with another. It is valid for one revision of the document.
struct MeshDeviation {
  QString file;               // the file that the mesh was compared with; empty: the mesh as it was opened
  std::uint64_t changes = 0;  // MeshTab::changes of the mesh that was compared
  Deviation statistics;
  VertexValues atVertex;  // the deviations at the vertices, which statistics.ofMesh does not contain
  std::shared_ptr<const SurfaceDistance> scan;  // the surface that the mesh was compared with
  double diagonal = 0.0;                        // diagonal of the scan, mm
  ColourScale scale;

  const SurfaceDeviation& ofMesh() const { return statistics.ofMesh; }
};

// Returns the area fractions in equally wide bins from -range to range. Values beyond the range are counted in the
// first or the last bin.
std::vector<double> sharesWithin(const SurfaceDeviation& deviation, double range, std::size_t bins);

}  // namespace handwheel
