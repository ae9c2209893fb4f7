// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "base/Units.h"
#include "document/DocumentFile.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/measure/Deviation.h"
#include "mesh/repair/Repair.h"

#include <filesystem>
#include <vector>

namespace handwheel {

class DocumentKinds;

// The parameters of the repair of one file.
struct RepairRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  ReadOptions read;
  RepairOptions options;
  bool inspectInput = false;  // inspects the input, as the report requires
  bool compare = false;       // measures the deviation
  // Unit of the numbers of the input. It is written into formats that have units; nothing is scaled.
  LengthUnit unit = LengthUnit::Millimetre;
};

// The result of the repair of one file.
struct RepairRun {
  MeshReport before;    // report on the input as it was read, if it is inspected
  MeshReport after;     // report on the bytes of the output, read again
  RepairReport repair;  // report with the faces flipped while building the mesh and the vertices split by the export
  std::vector<Vertex> modified;        // vertices of the input that were moved, merged or split
  bool unmodifiedIdentical = false;    // true if all other vertices have the same bits in the output
  std::optional<Deviation> deviation;  // deviation of the result from the input, if they are compared
  DocumentFile file;                   // the document, with the losses of reading the input
  double roundingMove = 0.0;           // largest move of an input point by rounding to the output's number type, mm
  double seconds = 0.0;
  std::string output;             // the bytes to write
  std::vector<int> unknownLoops;  // loops to keep open that do not exist; if any, nothing was repaired
  std::string refusal;            // reason not to replace the output; if set, nothing was repaired
  bool nothingLeft = false;       // true if every face was removed, so that there is nothing to write
};

// Reads and repairs a mesh file and produces the bytes of the output. Reads these bytes again to measure them. Writes
// nothing, so that all errors occur before the output is replaced. The input's coordinates are first rounded to the
// number type of the output, so that the repair works on the coordinates that the file will hold. Loops that a
// container marks to be kept open are kept; a container made from one keeps its marks, its id, its unit and the data
// that only other programs understand.
Result<RepairRun> repairFile(const RepairRequest& request, const DocumentKinds& kinds, Progress progress);

}  // namespace handwheel
