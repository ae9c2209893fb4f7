// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentKind.h"
#include "mesh/defects/MeshReport.h"

#include <optional>

namespace handwheel {

struct MeshSnapshot;

// The triangles of a mesh as its file holds them, unwelded.
struct MeshInput {
  NumberType numbers = NumberType::Float64;
  TriangleSoup soup;
};

// The contents of a file named on the command line.
struct Input {
  OpenedFile opened;              // for a mesh file that is not a container, without its content
  std::optional<MeshInput> mesh;  // present for every mesh

  // Returns the mesh of a container, or null if the input is no container.
  const MeshSnapshot* meshDocument() const;
};

// Reads a file. Errors: those of the readers.
Result<Input> readInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                        Progress progress);

// Reads a mesh file. Errors: Unsupported for other kinds of documents; those of the readers.
Result<Input> readMeshInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                            Progress progress);

// Measures a mesh and finds its defects. The loops of a document keep its own numbering: edits may have put them in
// another order than the triangles alone would give. The report is incomplete after a cancellation.
MeshReport reportOn(const Input& mesh, SelfIntersections choice, Progress progress);

// Returns one sentence for each loss on reading: a part that is not readable, not understood or not kept. Then the
// notes.
std::vector<std::string> lossSentences(const DocumentFile& file);
// Prints these sentences on stderr.
void reportLosses(const DocumentFile& file);

// Returns true if two paths name the same file. Symbolic and hard links count as their target. The files need not
// exist.
bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b);

// Returns true if the extension of the path is that of a document. Other data must not be written there.
bool isDocumentName(const std::filesystem::path& path, const DocumentKinds& kinds);

// Returns the reason why this file cannot be written, as a sentence, or an empty string. It must not be one of the
// inputs.
std::string refusalToOverwrite(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs);
// Does the same for data that are no document, which must not have the name of one either. option: such as "--csv".
std::string refusalOfData(const std::string& option, const std::filesystem::path& output,
                          const std::vector<std::filesystem::path>& inputs, const DocumentKinds& kinds);

// Returns the reason why the output must not be overwritten, as a sentence, or an empty string. The reason is that a
// newer program wrote the document there, or that it is the document that was read and is damaged.
std::string refusalToReplace(const std::filesystem::path& output, const DocumentFile& input);

}  // namespace handwheel
