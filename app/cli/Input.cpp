// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Input.h"

#include "cli/Messages.h"
#include "cli/Wording.h"
#include "document/DocumentErrors.h"
#include "document/NewerFile.h"
#include "document/mesh/MeshKind.h"
#include "text/LossText.h"
#include "text/NoteText.h"

#include <QString>
#include <algorithm>

namespace handwheel {

namespace {

Result<Input> readMesh(const DocumentKind& kind, const std::filesystem::path& path, const ReadOptions& options,
                       const DocumentKinds& kinds, Progress progress) {
  Result<MeshFile> file = readMeshFile(path, options, progress);
  if (!file) {
    Error error = file.error();
    if (error.code == DocumentError::FormatUnknown) error.arguments = kinds.readEndings();
    return error;
  }
  Input input;
  input.opened.kind = &kind;
  input.opened.file.path = path.string();
  input.opened.file.damage = std::move(file->damage);
  input.opened.file.unlistedDamage = file->unlistedDamage;
  input.opened.file.lost = std::move(file->lost);
  input.opened.file.lostOther = std::move(file->lostOther);
  input.opened.file.hasUnit = file->hasUnit;
  input.opened.file.notes = std::move(file->notes);
  input.mesh = MeshInput{file->numbers, std::move(file->soup)};
  return input;
}

}  // namespace

const MeshSnapshot* Input::meshDocument() const {
  return mesh && opened.content ? static_cast<const MeshSnapshot*>(opened.content.get()) : nullptr;
}

Result<Input> readInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                        Progress progress) {
  const Result<const DocumentKind*> kind = kinds.kindOf(path);
  if (!kind) return kind.error();
  if (*kind && (*kind)->id() == kMeshKind) return readMesh(**kind, path, options, kinds, progress);
  Result<OpenedFile> opened = kinds.open(path, options, progress);
  if (!opened) return opened.error();
  Input input{std::move(opened.value()), std::nullopt};
  if (input.opened.kind->id() == kMeshKind) {
    const auto& content = static_cast<const MeshSnapshot&>(*input.opened.content);
    input.mesh = MeshInput{content.numbers, content.mesh.mesh.compact().soup};
  }
  return input;
}

Result<Input> readMeshInput(const std::filesystem::path& path, const ReadOptions& options, const DocumentKinds& kinds,
                            Progress progress) {
  const auto refusal = [&](const DocumentKind& kind) {
    return Error{ErrorCode::Unsupported, {"this command on a " + kind.id()}, {}, path.string()};
  };
  const Result<const DocumentKind*> kind = kinds.kindOf(path);
  if (kind && *kind && (*kind)->id() != kMeshKind) return refusal(**kind);  // before all of it is read
  Result<Input> input = readInput(path, options, kinds, progress);
  if (!input || input->mesh) return input;
  return refusal(*input->opened.kind);
}

MeshReport reportOn(const Input& mesh, SelfIntersections choice, Progress progress) {
  MeshReport report = reportOn(mesh.mesh->soup, choice, progress);
  if (const MeshSnapshot* document = mesh.meshDocument()) report.loops = reportOn(document->mesh.defects->loops);
  return report;
}

std::vector<std::string> lossSentences(const DocumentFile& file) {
  std::vector<std::string> all;
  if (file.isNewer)
    all.emplace_back("A newer version of Handwheel wrote the file; only what this version knows was read.");
  for (std::string& note : damageSentences(file)) all.push_back(std::move(note));
  if (!file.lost.empty()) all.push_back("Not kept: " + lostText(file).toStdString() + ".");
  for (const Note& note : file.notes) all.push_back(noteText(note).toStdString());
  return all;
}

void reportLosses(const DocumentFile& file) {
  for (const std::string& sentence : lossSentences(file)) complain(sentence);
}

bool isSameFile(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code ignored;
  if (std::filesystem::equivalent(a, b, ignored)) return true;
  const auto whole = [&](const std::filesystem::path& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, ignored), ignored);
  };
  return whole(a) == whole(b);
}

bool isDocumentName(const std::filesystem::path& path, const DocumentKinds& kinds) {
  const auto hasEndingOf = [name = QString::fromStdString(path.string())](const std::unique_ptr<DocumentKind>& kind) {
    const std::vector<FileFormat> formats = kind->formats();
    return std::any_of(formats.begin(), formats.end(), [&](const FileFormat& format) {
      return std::any_of(format.endings.begin(), format.endings.end(), [&](const std::string& ending) {
        return name.endsWith(QString::fromStdString(ending), Qt::CaseInsensitive);
      });
    });
  };
  return isContainerName(path) || std::any_of(kinds.all().begin(), kinds.all().end(), hasEndingOf);
}

std::string refusalToOverwrite(const std::filesystem::path& output, const std::vector<std::filesystem::path>& inputs) {
  for (const std::filesystem::path& input : inputs)
    if (!input.empty() && isSameFile(output, input))
      return output.string() + " is an input and is not replaced. Write to another file.";
  return {};
}

std::string refusalOfData(const std::string& option, const std::filesystem::path& output,
                          const std::vector<std::filesystem::path>& inputs, const DocumentKinds& kinds) {
  if (isDocumentName(output, kinds))
    return option + " takes another name than " + output.string() + ", which is that of a document.";
  return refusalToOverwrite(output, inputs);
}

std::string refusalToReplace(const std::filesystem::path& output, const DocumentFile& input) {
  if (!checkNotNewer(output)) {
    return output.string() +
           " was written by a newer version of Handwheel and is not replaced, so that no content unknown to this "
           "version is lost. Write to another file.";
  }
  const bool isWhole = input.damage.empty() && input.unlistedDamage == 0;
  if (!input.isContainer || isWhole || !isSameFile(input.path, output)) return {};
  return output.string() + " is damaged and is not replaced, to prevent further loss. Write to another file.";
}

}  // namespace handwheel
