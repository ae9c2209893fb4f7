// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/AtomicFile.h"
#include "document/formats/MeshFormat.h"
#include "mesh/HalfEdgeMesh.h"
#include "mesh/MeshReport.h"

#include <filesystem>

namespace handwheel {

struct ExportReport {
  // Vertices moved by the smallest visible amount because in the file they would have welded with another one.
  std::vector<Vertex> parted;
  std::size_t bytes = 0;
  // The file's triangles after welding equal positions, as another program will see them; self-intersections left out.
  MeshReport inFile;
};

struct EncodedMesh {
  std::string bytes;
  ExportReport report;
};

// The bytes of a file of this name that holds the live faces of a mesh, read back, compared with it, welded and
// measured. Errors: as below, and OutOfMemory.
Result<EncodedMesh> encodeMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                               Progress progress = {});

// Writes them: the whole file or nothing. Vertices that only rounding to the file's number type puts in one place
// are parted where an edge would else get more than two faces, or two the same way. Errors: ExtensionUnknown,
// WriteFailed, CheckFailed, Cancelled.
Result<ExportReport> exportMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                                Progress progress = {});

// The format that a file's name asks for, or ExtensionUnknown with all that a mesh document can be saved as.
Result<MeshFormat> formatForOutput(const std::filesystem::path& path);

// The bytes of a file that holds these triangles, checked: the reader gives every corner of every triangle the very
// number it had, rounded to the number type. So the file welds as the rounded triangles do. Errors: CheckFailed,
// OutOfMemory, Cancelled.
Result<std::string> encodeChecked(const TriangleSoup& soup, MeshFormat format, NumberType numbers,
                                  Progress progress = {});

}  // namespace handwheel
