// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "mesh/MeshReport.h"

#include <optional>

namespace handwheel {

struct MeshSnapshot;

// The triangles of a mesh as its file holds them, unwelded.
struct MeshInput {
  NumberType numbers = NumberType::Float64;
  TriangleSoup soup;
};

// What a file named on the command line holds.
struct Input {
  OpenedFile opened;              // of a mesh file that is no container without its content
  std::optional<MeshInput> mesh;  // of every mesh

  const MeshSnapshot* meshDocument() const;  // of a mesh in a container; else null
};

// Errors: those of the readers.
Result<Input> readInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                        Progress progress);

// The same for commands that work on meshes only: others are Unsupported.
Result<Input> readMeshInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                            Progress progress);

// The figures of a mesh. The loops of a document have its own numbers: edits may have put them in another order than
// the triangles alone would. Incomplete once cancelled.
MeshReport reportOn(const Input& mesh, SelfIntersections choice, Progress progress);

// What could not be read, is not understood, or is not kept, a sentence each; and says it.
std::vector<std::string> lossSentences(const DocumentFile& file);
void tellLosses(const DocumentFile& file);

// A link, symbolic or hard, and what it leads to are the same. They need not exist.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

// Whether a document has such a name, by its ending: what is no document must not be written there.
bool isDocumentName(const std::filesystem::path& path, const DocumentKinds& kinds);

// Why nothing must be written there, as a sentence: a newer program wrote the document that stands there, or it is the
// very document that was read, and damaged. Empty when it may.
std::string refusalToReplace(const std::filesystem::path& output, const DocumentFile& input);

}  // namespace handwheel
