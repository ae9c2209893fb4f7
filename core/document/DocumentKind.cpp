// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/DocumentKind.h"

#include "base/JsonText.h"
#include "document/AtomicFile.h"
#include "document/DocumentErrors.h"
#include "document/FileBytes.h"
#include "document/NewerFile.h"
#include "document/container/ContainerLayout.h"
#include "document/container/RecordingBlobs.h"
#include "document/container/UnknownPart.h"
#include "mesh/structure/Weld.h"
#include "scene/MeshGeometry.h"

#include <QUuid>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr const char *kAssigned = "exercise", *kDescription = "description", *kAttempt = "attempt";

LengthUnit unitNamed(const std::string& symbol) {
  for (LengthUnit unit : {LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch}) {
    if (symbol == symbolOf(unit)) return unit;
  }
  return LengthUnit::Millimetre;
}

// Returns the container of a document without the ticks of its recordings. path: the target file.
Container ownPart(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                  const std::filesystem::path& path) {
  Container own;
  std::error_code ignored;
  if (!path.empty()) own.folder = std::filesystem::absolute(path, ignored).parent_path();
  nlohmann::json& manifest = *own.manifest;
  manifest["id"] = file.id.empty() ? newDocumentId() : file.id;
  manifest["kind"] = kind.id();
  manifest["display_unit"] = symbolOf(file.displayUnit);
  listRecordings(file.recordings, manifest);
  if (file.assigned)
    manifest[kAssigned] = {{kDescription, *file.assigned.description}, {kAttempt, *file.assigned.attempt}};
  kind.save(content, own);
  return own;
}

// Returns the exercise that the document belongs to; anything else is left to the unknown keys.
AssignedExercise assignedIn(const nlohmann::json& manifest) {
  const auto found = manifest.find(kAssigned);
  if (found == manifest.end() || !found->is_object()) return {};
  const auto part = [&](const char* key) {
    const auto at = found->find(key);
    return at != found->end() && at->is_object() ? std::make_shared<const nlohmann::json>(*at) : nullptr;
  };
  AssignedExercise assigned{part(kDescription), part(kAttempt)};
  return assigned ? assigned : AssignedExercise();
}

// Stores the unknown part that is written back when the document is saved.
void keepUnknown(OpenedFile& opened, const Container& read) {
  Container known = ownPart(*opened.kind, opened.file, *opened.content, {});
  const std::string folders[] = {opened.kind->id() + "/", kRecordingFolder};
  opened.file.unknown = std::make_shared<const Container>(unknownPart(read, known, folders));
  known.blobs.clear();
  opened.file.known = std::make_shared<const Container>(std::move(known));
}

Result<OpenedFile> load(const DocumentKinds& kinds, std::string_view bytes, Progress progress) {
  Result<ReadContainer> read = readContainer(bytes, progress.part(0.0, 0.4));
  if (!read) return read.error();
  const nlohmann::json& manifest = *read->container.manifest;
  const std::string kindId = stringAt(manifest, "kind");
  const DocumentKind* kind = kinds.withId(kindId);
  if (!kind) return Error{DocumentError::KindUnknown, {kindId}, {}, {}};
  OpenedFile opened;
  opened.kind = kind;
  opened.file.damage = read->damage;
  Result<SnapshotPointer> content = kind->load(read->container, opened.file.damage, progress.part(0.4, 1.0));
  if (!content) return content.error();
  opened.content = std::move(content.value());
  opened.file.id = stringAt(manifest, "id");
  if (opened.file.id.empty()) opened.file.id = newDocumentId();
  opened.file.displayUnit = unitNamed(stringAt(manifest, "display_unit"));
  opened.file.recordings = readRecordings(read->container, opened.file.damage);
  opened.file.assigned = assignedIn(manifest);
  opened.file.isContainer = true;
  opened.file.isNewer = read->isNewer;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  keepUnknown(opened, read->container);
  return opened;
}

Result<const DocumentKind*> recognised(const DocumentKinds& kinds, const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    for (const auto& kind : kinds.all())
      if (kind->readsFolders()) return static_cast<const DocumentKind*>(kind.get());
  }
  const Result<std::string> head = readFileHead(path);
  if (!head) return head.error();
  if (head->empty()) return Error{ErrorCode::FileEmpty, {}, {}, {}};
  if (isContainerName(path) || looksLikeContainer(*head)) return static_cast<const DocumentKind*>(nullptr);
  const std::string name = path.filename().string();
  for (const auto& kind : kinds.all()) {
    if (kind->recognises(*head, name)) return static_cast<const DocumentKind*>(kind.get());
  }
  return Error{DocumentError::FormatUnknown, kinds.readEndings(), {}, {}};
}

Result<OpenedFile> openAny(const DocumentKinds& kinds, const std::filesystem::path& path, const ReadOptions& options,
                           Progress progress) {
  const Result<const DocumentKind*> kind = recognised(kinds, path);
  if (!kind) return kind.error();
  if (*kind) {
    Result<OpenedFile> opened = (*kind)->import(path, options, progress);
    if (opened) opened->file.id = newDocumentId();
    return opened;
  }
  const Result<std::string> bytes = readFileBytes(path, progress.part(0.0, 0.2));
  if (!bytes) return bytes.error();
  Result<OpenedFile> opened = load(kinds, *bytes, progress.part(0.2, 0.9));
  if (!opened) return opened;
  opened->content = opened->kind->withCheckedLinks(std::move(opened->content), path.parent_path(), opened->file.notes,
                                                   progress.part(0.9, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return opened;
}

// Checks that every blob is read back with its checksum.
Status checkReadable(std::string_view bytes, Progress progress) {
  const Result<ReadContainer> back = readContainer(bytes, progress);
  if (back && back->damage.empty()) return Done{};
  if (!back && (back.error().code == ErrorCode::Cancelled || back.error().code == ErrorCode::OutOfMemory)) {
    return back.error();
  }
  return Error{DocumentError::CheckFailed, {"it cannot be opened"}, {}, {}};
}

void addEndings(std::vector<std::string>& all, const std::vector<FileFormat>& formats, bool FileFormat::*wanted) {
  for (const FileFormat& format : formats) {
    if (format.*wanted) all.insert(all.end(), format.endings.begin(), format.endings.end());
  }
}

Error withSubject(Error error, const std::filesystem::path& path) {
  if (error.subject.empty()) error.subject = path.string();
  return error;
}

}  // namespace

std::string newDocumentId() {
  return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

SnapshotPointer DocumentKind::withCheckedLinks(SnapshotPointer content, const std::filesystem::path&,
                                               std::vector<Note>&, Progress) const {
  return content;
}

GeometryPointer DocumentKind::bodyGeometry(const Snapshot& content, std::vector<Note>&) const {
  TriangleSoup soup = placedSoup(display(content));
  if (!isSoundSoup(soup)) return nullptr;
  return std::make_shared<const MeshGeometry>(weld(soup));
}

Result<SnapshotPointer> DocumentKind::ofSurface(const TriangleSoup&, const std::string&, Progress) const {
  return Error{ErrorCode::Unsupported, {id()}, {}, {}};
}

DocumentKinds::DocumentKinds(std::vector<std::unique_ptr<DocumentKind>> kinds) : m_kinds(std::move(kinds)) {}

const DocumentKind* DocumentKinds::withId(std::string_view id) const {
  const auto found = std::find_if(m_kinds.begin(), m_kinds.end(), [&](const auto& kind) { return kind->id() == id; });
  return found == m_kinds.end() ? nullptr : found->get();
}

Result<OpenedFile> DocumentKinds::open(const std::filesystem::path& path, const ReadOptions& options,
                                       Progress progress) const {
  const std::optional<FileTimestamp> stamp = timestampOf(path);
  Result<OpenedFile> opened = layout::catchOutOfMemory([&] { return openAny(*this, path, options, progress); });
  if (opened) {
    std::error_code ignored;
    opened->file.stamp = stamp;
    opened->file.path = std::filesystem::absolute(path, ignored).string();
    return opened;
  }
  // The mesh readers do not know the extensions of other kinds.
  Error error = withSubject(opened.error(), path);
  if (error.code == DocumentError::FormatUnknown) error.arguments = readEndings();
  return error;
}

Result<OpenedFile> DocumentKinds::openContainer(std::string_view bytes, Progress progress) const {
  return layout::catchOutOfMemory([&] { return load(*this, bytes, progress); });
}

std::vector<std::string> DocumentKinds::readEndings() const {
  std::vector<std::string> all;
  for (const auto& kind : m_kinds) addEndings(all, kind->formats(), &FileFormat::reads);
  all.emplace_back(kContainerEnding);
  return all;
}

Result<const DocumentKind*> DocumentKinds::kindOf(const std::filesystem::path& path) const {
  Result<const DocumentKind*> kind = recognised(*this, path);
  return kind ? kind : Result<const DocumentKind*>(withSubject(kind.error(), path));
}

OpenedFile DocumentKinds::blank(const DocumentKind& kind) {
  OpenedFile opened;
  opened.kind = &kind;
  opened.content = kind.blank();
  opened.file.id = newDocumentId();
  return opened;
}

std::vector<std::string> writtenEndings(const std::vector<FileFormat>& formats) {
  std::vector<std::string> all;
  addEndings(all, formats, &FileFormat::writes);
  all.emplace_back(kContainerEnding);
  return all;
}

Error unknownEnding(const std::filesystem::path& path, std::vector<std::string> written) {
  written.insert(written.begin(), path.extension().string());
  return {DocumentError::ExtensionUnknown, std::move(written), {}, path.string()};
}

bool isContainerName(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return ending == kContainerEnding;
}

Result<Container> containerOf(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                              const std::filesystem::path& path, Progress progress) {
  Container container = ownPart(kind, file, content, path);
  writeRecordings(file.recordings, container);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (file.unknown) container = merged(*file.unknown, std::move(container), file.known ? *file.known : Container());
  return container;
}

Result<std::string> containerBytes(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                   const std::filesystem::path& path, Compression compression, Progress progress) {
  const Result<Container> container = containerOf(kind, file, content, path, progress.part(0.0, 0.2));
  if (!container) return container.error();
  return writeContainer(*container, compression, progress.part(0.2, 1.0));
}

Result<std::string> checkedContainer(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                     const std::filesystem::path& path, Progress progress) {
  if (const Status may = checkNotNewer(path); !may) return may.error();
  Result<std::string> bytes = containerBytes(kind, file, content, path, Compression::Fast, progress.part(0.0, 0.875));
  if (!bytes) return withSubject(bytes.error(), path);
  if (const Status whole = checkReadable(*bytes, progress.part(0.875, 1.0)); !whole)
    return withSubject(whole.error(), path);
  return bytes;
}

Result<WrittenFile> saveDocument(const DocumentKind& kind, const DocumentFile& file, const Snapshot& content,
                                 const std::filesystem::path& path, Progress progress) {
  for (const std::filesystem::path& linked : kind.linkedFiles(content)) {
    std::error_code ignored;
    if (std::filesystem::equivalent(linked, path, ignored))
      return Error{DocumentError::ReplacesLinked, {}, {}, path.string()};
  }
  if (!isContainerName(path)) {
    if (const Status may = checkNotNewer(path); !may) return may.error();
    Result<WrittenFile> written = kind.exportTo(content, path, progress);
    if (!written && written.error().code == DocumentError::ExtensionUnknown)
      return unknownEnding(path, writtenEndings(kind.formats()));
    if (written && !file.recordings.empty())
      written->notes.push_back(
          {QT_TRANSLATE_NOOP("Note", "The recordings of the device are not in this file."), {}, true});
    return written;
  }
  const Result<std::string> bytes = checkedContainer(kind, file, content, path, progress.part(0.0, 0.8));
  if (!bytes) return bytes.error();
  const Status written = writeFileAtomically(path, *bytes, progress.part(0.8, 1.0));
  if (!written) return written.error();
  return WrittenFile{bytes->size(), {}};
}

}  // namespace handwheel
