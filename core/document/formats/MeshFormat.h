// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Note.h"
#include "mesh/structure/TriangleSoup.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A mesh file format: its row in the table of formats (MeshFormatTable.h). Lists the formats that the code refers to.
enum class MeshFormat { Stl, Ply, Obj, Off, ThreeMf };

// Content of a file that the mesh does not keep. The names are meant for the user ("vertex colour", "texture
// coordinates").
enum class LostAttribute {
  Colour,
  Normals,
  TextureCoordinates,
  Materials,
  Groups,
  Lines,
  Points,
  Curves,
  ExactSurfaces,
  Other
};

// Options for reading a file.
struct ReadOptions {
  bool partial = false;  // read the undamaged parts and list the damage instead of failing
  // Largest distance of the triangles from the exact surfaces of a STEP file, as a share of its diagonal.
  double stepChord = 2e-4;
};

// Result of reading a mesh file.
struct MeshFile {
  MeshFormat format = MeshFormat::Stl;
  NumberType numbers = NumberType::Float32;  // type of the coordinates in the file
  TriangleSoup soup;
  std::vector<Error> damage;       // parts that were skipped or repaired; empty if the file conforms to its format
  std::size_t unlistedDamage = 0;  // further damage beyond the first thousand entries
  std::vector<LostAttribute> lost;
  std::vector<std::string> lostOther;  // names of LostAttribute::Other in the file; the first few, and "" for more
  std::vector<Note> notes;             // other remarks on reading it
  bool hasUnit = false;                // the file defines its unit of length; its numbers were converted to mm
};

// Reads a mesh of any known format, recognised by content. Never throws; errors carry the byte or the line. O(file
// size); memory for the bytes and the soup. nameHint: the file name, used only if the content is ambiguous.
Result<MeshFile> readMesh(std::string_view bytes, std::string_view nameHint, const ReadOptions& options,
                          Progress progress = {});
// Reads a mesh from a file; see readMesh().
Result<MeshFile> readMeshFile(const std::filesystem::path& path, const ReadOptions& options, Progress progress = {});

// Returns the format for the extension of a file name.
std::optional<MeshFormat> formatForName(std::string_view name);

// Returns the number type in which a format stores coordinates. STL has single precision; the others keep the
// document's.
NumberType numberTypeOf(MeshFormat format, NumberType documentNumbers);

// Encodes triangles as the bytes of a file of this format, which must be one that is written. STL and PLY are binary
// little-endian; text has the shortest digits that read back to the same number. 3MF is in millimetres. Empty if
// cancelled.
std::string writeMesh(const TriangleSoup& soup, MeshFormat format, NumberType numbers, Progress progress = {});

}  // namespace handwheel
