// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Input.h"

#include "cli/Messages.h"
#include "cli/Wording.h"
#include "document/mesh/MeshKind.h"

namespace handwheel {

Result<Input> readInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                        Progress progress) {
  Input input;
  const Result<const DocumentKind*> kind = kinds.kindOf(path);
  if (!kind) return kind.error();
  if (*kind && (*kind)->id() == kMeshKind) {
    Result<MeshFile> file = readMeshFile(path, options, progress);
    if (!file) return file.error();
    input.mesh = std::move(file.value());
    return input;
  }
  Result<OpenedFile> opened = kinds.open(path, options, progress);
  if (!opened) return opened.error();
  input.document = std::move(opened.value());
  if (input.document.kind->id() == kMeshKind) {
    const auto& content = static_cast<const MeshSnapshot&>(*input.document.content);
    input.mesh = MeshFile{.numbers = content.numbers,
                          .soup = content.mesh.mesh.compact().soup,
                          .damage = input.document.file.damage,
                          .unlistedDamage = input.document.file.unlistedDamage,
                          .lost = {}};
  }
  return input;
}

Result<MeshFile> readMeshInput(const std::filesystem::path& path, const ReadOptions& options,
                               const DocumentKinds& kinds, Progress progress) {
  Result<Input> input = readInput(path, options, kinds, progress);
  if (!input) return input.error();
  if (input->mesh) return std::move(*input->mesh);
  return Error{ErrorCode::Unsupported, {"this command on a " + input->document.kind->id()}, {}, path.string()};
}

void tellLosses(const std::vector<Error>& damage, std::size_t unlistedDamage, const std::vector<LostAttribute>& lost) {
  for (const std::string& note : damageSentences(damage, unlistedDamage)) complain(note);
  if (!lost.empty()) complain("Not kept: " + listOf(lost) + ".");
}

}  // namespace handwheel
