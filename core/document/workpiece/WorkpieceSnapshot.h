// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"
#include "document/workpiece/StockMesh.h"

#include <string>

namespace handwheel {

// The value of a workpiece document: the bar that a part will be made of.
struct WorkpieceSnapshot : Snapshot {
  // Within these limits (mm) a bar of any size has triangles that the program can show and write.
  static constexpr double kLeastChord = 1e-4, kLargestChord = 1e3;

  WorkpieceSnapshot() : mesh(std::make_shared<const StockMesh>(stock, chord)) {}

  StockCylinder stock;
  double chord = 0.01;                    // mm, tolerance of its triangles
  std::string material;                   // name in the user's words, UTF-8
  std::shared_ptr<const StockMesh> mesh;  // of stock and chord; never null
};

}  // namespace handwheel
