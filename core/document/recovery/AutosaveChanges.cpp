// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/AutosaveChanges.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/AtomicFile.h"
#include "document/FileBytes.h"
#include "document/container/ContainerLayout.h"
#include "document/recovery/RecoveryFiles.h"

#include <nlohmann/json.hpp>
#include <utility>

namespace handwheel {

namespace {

using nlohmann::json;

// Keys in the manifest of changes: the file that they belong to, and its blobs that stay.
constexpr const char *kBase = "autosave", *kBytes = "bytes", *kChecksum = "crc32", *kBlobs = "blobs";

ByteSum sumOf(std::string_view bytes) {
  return {bytes.size(), layout::checksumText(bytes)};
}

json textOf(const ByteSum& sum) {
  return {{kBytes, sum.bytes}, {kChecksum, sum.checksum}};
}

bool isThis(const json& text, std::string_view bytes) {
  return countAt(text, kBytes) == bytes.size() && stringAt(text, kChecksum) == layout::checksumText(bytes);
}

// Returns true if the changes belong to another autosave than this, and both are undamaged. Errors: OutOfMemory.
Result<bool> areOfAnother(std::string_view autosave, std::string_view changes) {
  const auto isLacking = [](const Result<ReadContainer>& read) {
    return !read && read.error().code == ErrorCode::OutOfMemory;
  };
  {
    const Result<ReadContainer> read = readContainer(changes);
    if (isLacking(read)) return read.error();
    if (!read) return false;
    const json base = JsonFieldReader(*read->container.manifest).member(kBase);
    if (!base.is_object() || isThis(base, autosave)) return false;
  }
  const Result<ReadContainer> whole = readContainer(autosave);
  if (isLacking(whole)) return whole.error();
  return whole && whole->damage.empty();
}

}  // namespace

StoredAutosave storedAutosave(const Container& container, std::string_view archive) {
  StoredAutosave stored{sumOf(archive), {}};
  for (const auto& [name, bytes] : container.blobs) stored.blobs.emplace(name, sumOf(bytes));
  return stored;
}

std::optional<Container> changesSince(const StoredAutosave& stored, const Container& container) {
  Container changes;
  *changes.manifest = *container.manifest;
  json kept = json::object();
  std::uint64_t changed = 0, all = 0;
  for (const auto& [name, bytes] : container.blobs) {
    all += bytes.size();
    const auto found = stored.blobs.find(name);
    if (found != stored.blobs.end() && found->second.bytes == bytes.size() && found->second == sumOf(bytes)) {
      kept[name] = textOf(found->second);
      continue;
    }
    changed += bytes.size();
    if (changed > stored.file.bytes / 2) return {};
    changes.blobs.emplace(name, bytes);
  }
  if (changed > all / 2 || kept.empty()) return {};
  json base = textOf(stored.file);
  base[kBlobs] = std::move(kept);
  (*changes.manifest)[kBase] = std::move(base);
  return changes;
}

std::optional<Container> withChanges(std::string_view autosave, std::string_view changes) {
  Result<ReadContainer> read = readContainer(changes);
  if (!read || !read->damage.empty()) return {};
  Container joined = std::move(read->container);
  const json base = JsonFieldReader(*joined.manifest).member(kBase);
  if (!isThis(base, autosave)) return {};
  Result<ReadContainer> whole = readContainer(autosave);
  if (!whole) return {};
  const json& kept = JsonFieldReader(base).member(kBlobs);
  if (!kept.is_object()) return {};
  for (const auto& [name, sum] : kept.items()) {
    const auto found = whole->container.blobs.find(name);
    if (found == whole->container.blobs.end() || !isThis(sum, found->second)) return {};
    joined.blobs.emplace(name, std::move(found->second));
  }
  joined.manifest->erase(kBase);
  return joined;
}

Result<JoinedChanges> joinChanges(const std::filesystem::path& autosave, Progress progress) {
  const std::filesystem::path beside = recovery::changesFile(autosave);
  std::error_code ignored;
  if (!std::filesystem::exists(beside, ignored)) return JoinedChanges::All;
  const Result<std::string> changes = readFileBytes(beside, progress.part(0.0, 0.1));
  if (!changes) return changes.error();
  const Result<std::string> base = readFileBytes(autosave, progress.part(0.1, 0.3));
  if (!base) return base.error();
  const std::optional<Container> joined = withChanges(*base, *changes);
  if (!joined) {
    const Result<bool> other = areOfAnother(*base, *changes);
    if (!other) return other.error();
    if (*other) return JoinedChanges::All;
    std::error_code failed;
    std::filesystem::rename(beside, recovery::damagedFile(autosave), failed);
    if (failed) return Error{ErrorCode::WriteFailed, {failed.message()}, {}, beside.string()};
    return JoinedChanges::Damaged;
  }
  const Result<std::string> bytes = writeContainer(*joined, Compression::None, progress.part(0.3, 0.6));
  if (!bytes) return bytes.error();
  if (const Status written = writeFileAtomically(autosave, *bytes, progress.part(0.6, 1.0)); !written)
    return written.error();
  std::filesystem::remove(beside, ignored);  // if that fails, they no longer belong to this file
  return JoinedChanges::All;
}

}  // namespace handwheel
