// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Result.h"
#include "document/DocumentFile.h"
#include "mesh/MeshReport.h"
#include "mesh/Repair.h"

#include <filesystem>
#include <vector>

namespace handwheel {

class DocumentKinds;

struct RepairRequest {
  std::filesystem::path input;
  std::filesystem::path output;
  ReadOptions read;
  RepairOptions options;
  bool inspectInput = false;  // as the report wants it
};

struct RepairRun {
  MeshReport before;                // of the input as it was read, when it is inspected
  MeshReport after;                 // of the bytes of the output, read again
  RepairReport repair;              // with the faces turned on building the mesh, and the vertices parted by the export
  std::vector<Vertex> touched;      // vertices of the input that were moved, merged or parted
  bool untouchedIdentical = false;  // measured on these bytes
  DocumentFile file;                // what reading the input lost
  double roundingMove = 0.0;        // mm; how far the numbers of the output moved the points of the input at most
  double seconds = 0.0;
  std::string output;             // the bytes to write
  std::vector<int> unknownLoops;  // asked to be kept open but not there: then nothing was repaired
  std::string refusal;            // why the output must not be replaced: then nothing was repaired
  bool nothingLeft = false;       // every face was removed: then there is nothing to write
};

// Reads, repairs, and makes the bytes of the output, which it reads again to measure them. It writes nothing: whatever
// can fail has failed before the output replaces anything. The input's coordinates are rounded to the
// numbers of the output first, so that what is repaired is what the file will hold. Loops that a container marks to be
// kept open are; a container made from one keeps its marks, its id, its unit and what only others know of it.
Result<RepairRun> repairFile(const RepairRequest& request, const DocumentKinds& kinds, Progress progress);

}  // namespace handwheel
