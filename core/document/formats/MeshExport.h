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
  // Vertices moved by the smallest representable amount because they would have welded with another one in the file.
  std::vector<Vertex> parted;
  double roundingMove = 0.0;  // mm; the largest move of a vertex by rounding to the file's number type
  std::size_t bytes = 0;
  // The file's triangles after welding equal positions, as another program will see them. Self-intersections are
  // counted if a vertex was rounded.
  MeshReport inFile;
  std::size_t roundingPairs = 0;       // pairs of triangles that intersect in the file only
  std::size_t roundingDegenerate = 0;  // triangles that are degenerate in the file only

  // Returns true if the file has the boundary of a solid, with none of its triangles lost to rounding.
  bool isSound() const { return inFile.isSound() && roundingDegenerate == 0; }
};

// Returns the messages about a file that was written.
std::vector<Note> notesOn(const ExportReport& report);

// A mesh as the bytes of a file, with its report.
struct EncodedMesh {
  std::string bytes;
  ExportReport report;
};

// Encodes a mesh in the format of a file name, and checks the result. The bytes have the live faces of the mesh; they
// are read back, compared with it, welded and measured. Errors: those of exportMesh(), and OutOfMemory.
Result<EncodedMesh> encodeMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                               Progress progress = {});

// Writes a mesh to a file: the whole file or nothing. Vertices that coincide only because of rounding to the file's
// number type are separated if an edge would otherwise get more than two faces, or two in the same direction. Errors:
// ExtensionUnknown, WriteFailed, CheckFailed, Cancelled.
Result<ExportReport> exportMesh(const HalfEdgeMesh& mesh, NumberType documentNumbers, const std::filesystem::path& path,
                                Progress progress = {});

// Returns the formats that meshes are read from and written to.
std::vector<FileFormat> meshFileFormats();

// Returns the format for the extension of a file name. Errors: ExtensionUnknown with all formats that a mesh can be
// written in.
Result<MeshFormat> formatForOutput(const std::filesystem::path& path);

// Encodes triangles as the bytes of a file, and checks them. The reader must return exactly the coordinates of every
// corner, rounded to the number type, so that the file welds as the rounded triangles do. Errors: CheckFailed,
// OutOfMemory, Cancelled.
Result<std::string> encodeChecked(const TriangleSoup& soup, MeshFormat format, NumberType numbers,
                                  Progress progress = {});

}  // namespace handwheel
