// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/mesh/MeshOutput.h"

#include "document/OperationText.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/MeshKind.h"

namespace handwheel {

OptionSpec meshOutputOption() {
  return {"output", 'o', "OUT", "The result: " + choicesText(writtenEndings(meshFileFormats())) + "; can be the input"};
}

std::string meshFormatWords(bool withContainer) {
  std::vector<std::string> words = writtenEndings(meshFileFormats());
  if (!withContainer) words.pop_back();
  for (std::string& word : words) word.erase(0, 1);
  return choicesText(words);
}

std::string meshFormatNames() {
  std::vector<std::string> names;
  for (const FileFormat& format : meshFileFormats()) names.push_back(format.name);
  return choicesText(names);
}

Status writeMesh(const Input& input, const HalfEdgeMesh& mesh, const std::filesystem::path& output, Progress progress) {
  if (!isContainerName(output)) {
    const auto exported = exportMesh(mesh, input.mesh->numbers, output, progress);
    return exported ? Status(Done{}) : Status(exported.error());
  }
  MeshFile file;
  file.soup = mesh.compact().soup;
  file.numbers = input.mesh->numbers;
  const auto content = meshSnapshotOf(file, tolerance::kNearWeld, progress.part(0.0, 0.5));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const auto saved = saveDocument(*input.opened.kind, input.opened.file, *content, output, progress.part(0.5, 1.0));
  return saved ? Status(Done{}) : Status(saved.error());
}

}  // namespace handwheel
