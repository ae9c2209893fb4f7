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

// A mesh file format, as its row in the table of formats (MeshFormatTable.h). Only formats that the code refers to have
// a name.
enum class MeshFormat { Stl, Ply, Obj, Off, ThreeMf };

// Content of a file that the mesh does not keep.
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
  // Largest distance of the triangles from the exact surfaces of a STEP file, as a fraction of its diagonal.
  double stepChord = 2e-4;
};

// Result of reading a mesh file.
struct MeshFile {
  MeshFormat format = MeshFormat::Stl;
  NumberType numbers = NumberType::Float32;  // type of the coordinates in the file
  TriangleSoup soup;
  std::vector<Error> damage;       // parts that were skipped or repaired; empty if the file conforms to its format
  std::size_t unlistedDamage = 0;  // number of further damaged parts after the first thousand
  std::vector<LostAttribute> lost;
  // Names in the file of LostAttribute::Other: the first few, then "" if there are more.
  std::vector<std::string> lostOther;
  std::vector<Note> notes;  // other remarks on reading the file
  bool hasUnit = false;     // the file defines its unit of length, and its lengths were converted to mm
};

// Reads a mesh of any known format, recognised by content. Never throws. Errors contain the byte or the line. O(size of
// the file). nameHint: the file name, used only if the content is ambiguous.
Result<MeshFile> readMesh(std::string_view bytes, std::string_view nameHint, const ReadOptions& options,
                          Progress progress = {});
// Reads a mesh from a file by means of readMesh().
Result<MeshFile> readMeshFile(const std::filesystem::path& path, const ReadOptions& options, Progress progress = {});

// Returns the format for the extension of a file name, or nothing if there is no such format.
std::optional<MeshFormat> formatForName(std::string_view name);

// Returns the number type in which a format stores coordinates. STL stores single precision; the other formats store
// the number type of the document.
NumberType numberTypeOf(MeshFormat format, NumberType documentNumbers);

// Encodes triangles as the bytes of a file of this format, which must be a format that is written. STL and PLY are
// written as binary little-endian; numbers in text have the fewest digits that read back to the same number. 3MF is
// written in millimetres. The result is empty if it was cancelled.
std::string writeMesh(const TriangleSoup& soup, MeshFormat format, NumberType numbers, Progress progress = {});

}  // namespace handwheel
