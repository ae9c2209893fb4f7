// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "mesh/defects/MeshReport.h"

#include <optional>

namespace handwheel {

struct MeshSnapshot;

// The triangles of a mesh as they are in its file, unwelded.
struct MeshInput {
  NumberType numbers = NumberType::Float64;
  TriangleSoup soup;
};

// The contents of a file named on the command line.
struct Input {
  OpenedFile opened;              // without content for a mesh file other than .handwheel
  std::optional<MeshInput> mesh;  // present for every mesh

  // Returns the mesh of a .handwheel file (a container), or null for any other input.
  const MeshSnapshot* meshDocument() const;
};

// Reads a file. Errors: the errors of the reader of its format.
Result<Input> readInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                        Progress progress);

// Reads a mesh file. Errors: Unsupported for other kinds of documents; the errors of readInput().
Result<Input> readMeshInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                            Progress progress);

// Measures a mesh and finds its defects. The boundary loops of a document keep their numbers. After edits these may
// differ from the numbers that the triangles alone would give. The report is incomplete after a cancellation.
MeshReport reportOn(const Input& mesh, SelfIntersections choice, Progress progress);

// Returns sentences about the parts that were not readable, not understood or not kept on reading, followed by the
// notes.
std::vector<std::string> lossSentences(const DocumentFile& file);
// Prints lossSentences() on stderr.
void reportLosses(const DocumentFile& file);

// Returns true if two paths name the same file. A symbolic or hard link counts as its target. The files need not exist.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

// Returns true if the path has the extension of a document. Other data must not be written to such a path.
bool isDocumentName(const std::filesystem::path& path, const DocumentKinds& kinds);

// Returns a sentence that refuses the output if it is one of the inputs; otherwise an empty string.
std::string refusalToOverwrite(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs);
// Returns a sentence that refuses an output for other data than a document, or an empty string. An output is refused if
// it is one of the inputs or has the name of a document. option: the option that names the output, such as "--csv".
std::string refusalOfData(const std::string& option, const std::filesystem::path& output,
                          const std::vector<std::filesystem::path>& inputs, const DocumentKinds& kinds);

// Returns the reason why the output must not be overwritten, as a sentence, or an empty string. The reason is that a
// newer version of the program wrote the output, or that the output is the document that was read, which is damaged.
std::string refusalToReplace(const std::filesystem::path& output, const DocumentFile& input);

}  // namespace handwheel
