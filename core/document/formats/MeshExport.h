// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/AtomicFile.h"
#include "document/DocumentKind.h"
#include "document/Note.h"
#include "document/formats/MeshFormat.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <filesystem>

namespace handwheel {

// Result of exporting a mesh.
struct ExportReport {
  // Vertices that were moved by one step of the number type, because they would have been welded with another vertex.
  std::vector<Vertex> parted;
  double roundingMove = 0.0;  // mm; the largest move of a vertex by rounding to the file's number type
  std::size_t bytes = 0;
  // The report on the file's triangles after welding equal positions, as another program reads them. Self-intersections
  // are counted.
  MeshReport inFile;
  std::size_t roundingPairs = 0;       // number of pairs of triangles that intersect only after rounding
  std::size_t roundingDegenerate = 0;  // number of triangles that are degenerate only after rounding

  // Returns true if the triangles in the file bound a solid and rounding made none of them degenerate.
  bool isSound() const { return inFile.isSound() && roundingDegenerate == 0; }
};

// Returns the messages for the user about a file that was written.
std::vector<Note> notesOn(const ExportReport& report);

// A mesh as the bytes of a file, with its report.
struct EncodedMesh {
  std::string bytes;
  ExportReport report;
};

// Encodes the live faces of a mesh in the format of a file name, and checks the result. The bytes are read back,
// compared with the mesh, welded and measured. Errors: ExtensionUnknown, CheckFailed, OutOfMemory, Cancelled.
Result<EncodedMesh> encodeMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                               Progress progress = {});

// Writes a mesh to a file. Writes the whole file or nothing. Vertices that coincide only because of rounding to the
// file's number type are separated if an edge would otherwise get more than two faces, or two in the same direction.
// Errors: the errors of encodeMesh(), WriteFailed.
Result<ExportReport> exportMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                                Progress progress = {});

// Returns the file formats of meshes.
std::vector<FileFormat> meshFileFormats();

// Returns the format for the extension of a file name. Errors: ExtensionUnknown with all formats that a mesh can be
// written in.
Result<MeshFormat> formatForOutput(const std::filesystem::path& path);

// Encodes triangles as the bytes of a file, and checks the bytes by reading them. The check fails unless the reader
// returns the exact coordinates of every corner, rounded to the number type. Errors: CheckFailed, OutOfMemory,
// Cancelled.
Result<std::string> encodeChecked(const TriangleSoup& soup, MeshFormat format, NumberType numbers,
                                  Progress progress = {});

}  // namespace handwheel
