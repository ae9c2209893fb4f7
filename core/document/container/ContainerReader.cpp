// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/JsonText.h"
#include "document/Container.h"
#include "document/container/ArchiveErrors.h"
#include "document/container/ContainerLayout.h"
#include "document/container/Migrations.h"
#include "document/container/ZipReader.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using namespace layout;
using nlohmann::json;

Result<std::string> readManifest(ZipReader& zip, std::vector<Error>& damage) {
  Result<std::string> text = zip.read(kManifest);
  if (!text && (text.error().code == ArchiveError::EntryDamaged || text.error().code == ArchiveError::EntryMissing)) {
    Result<std::string> copy = zip.read(kManifestCopy);
    if (copy) {
      damage.push_back(text.error());
      text = std::move(copy);
    }
  }
  if (text && text->size() > kLargestManifest) return tooLarge("bytes", text->size(), kLargestManifest);
  return text;
}

Result<json> parseManifest(std::string_view text) {
  Result<json> manifest = parseJson(text, kManifest);
  if (manifest && !manifest->is_object()) {
    return Error{ErrorCode::ElementMalformed, {kManifest, "it is not an object"}, {}, {}};
  }
  return manifest;
}

Result<std::uint64_t> versionOf(const json& manifest) {
  const auto program = manifest.find("handwheel");
  if (program != manifest.end() && program->is_object()) {
    const auto format = program->find("format");
    if (format != program->end() && format->is_number_unsigned() && format->get<std::uint64_t>() >= 1)
      return format->get<std::uint64_t>();
  }
  return Error{ErrorCode::ElementMalformed, {"handwheel", "the version of the format is missing"}, {}, {}};
}

bool matches(const json& entry, std::string_view bytes) {
  if (!entry.is_object()) return true;
  const auto size = entry.find("bytes"), checksum = entry.find("crc32");
  return (size == entry.end() || *size == bytes.size()) &&
         (checksum == entry.end() || *checksum == checksumText(bytes));
}

// Puts the blobs of an archive into a container: those that the manifest lists, and those that were added.
class BlobReading {
 public:
  BlobReading(ZipReader& zip, std::string_view manifestText, ReadContainer& read, Progress progress)
      : m_zip(zip), m_manifestText(manifestText), m_read(read), m_progress(progress) {
    json& manifest = *read.container.manifest;
    const auto table = manifest.find("blobs");
    if (table == manifest.end()) return;
    if (table->is_object())
      m_table = std::move(*table);
    else
      read.damage.push_back({ErrorCode::ElementMalformed, {"blobs", "it is not an object"}, {}, {}});
    manifest.erase(table);
  }

  Status readAll() {
    if (m_table.size() >= kLimits.entries) return tooLarge("entries", m_table.size(), kLimits.entries);
    for (const auto& [name, entry] : m_table.items()) {
      if (Status done = readOne(name, &entry); !done) return done;
    }
    // In a damaged archive an unknown name is probably a damaged one.
    if (m_zip.hasSalvaged() || !m_zip.directoryProblem().empty()) return Done{};
    for (const std::string& name : m_zip.names()) {
      const bool isFolder = name.ends_with('/');  // some archivers write folders
      if (isManifestName(name) || isFolder || m_table.contains(name)) continue;
      if (Status done = readOne(name, nullptr); !done) return done;
    }
    return Done{};
  }

 private:
  Status readOne(const std::string& name, const json* entry) {
    if (!isBlobName(name)) return lose({ArchiveError::EntryDamaged, {name}, {}, {}});
    m_progress.set(static_cast<double>(m_done++) / static_cast<double>(m_table.size() + m_zip.names().size()));
    Result<std::string> bytes = m_zip.read(name);
    if (!bytes) {
      const ErrorCode code = bytes.error().code;
      if (code != ArchiveError::EntryMissing && code != ArchiveError::EntryDamaged) return bytes.error();
      return lose(bytes.error());
    }
    if (!entry && *bytes == m_manifestText) return Done{};  // its copy, by a damaged name
    if (entry && !matches(*entry, *bytes)) return lose({ArchiveError::EntryDamaged, {name}, {}, {}});
    m_read.container.blobs.emplace(name, std::move(bytes.value()));
    return Done{};
  }

  Status lose(Error error) {
    m_read.damage.push_back(std::move(error));
    return Done{};
  }

  ZipReader& m_zip;
  std::string_view m_manifestText;
  ReadContainer& m_read;
  Progress m_progress;
  std::size_t m_done = 0;
  json m_table = json::object();
};

Result<ReadContainer> readFrom(ZipReader& zip, Progress progress) {
  if (zip.names().size() + zip.duplicates().size() >= kLimits.entries) {
    return Error{ErrorCode::FileTooLarge, {"entries", "", std::to_string(kLimits.entries)}, {}, {}};
  }
  ReadContainer read;
  if (!zip.directoryProblem().empty()) {
    const Error malformed{ArchiveError::Malformed, {zip.directoryProblem()}, {}, {}};
    if (zip.names().empty()) return malformed;
    read.damage.push_back(malformed);
  }
  for (const std::string& name : zip.duplicates()) read.damage.push_back({ArchiveError::EntryDamaged, {name}, {}, {}});
  const Result<std::string> text = readManifest(zip, read.damage);
  if (!text) return text.error();
  Result<json> manifest = parseManifest(*text);
  if (!manifest) return manifest.error();
  const Result<std::uint64_t> version = versionOf(*manifest);
  if (!version) return version.error();
  *read.container.manifest = std::move(manifest.value());
  if (const Status done = BlobReading(zip, *text, read, progress).readAll(); !done) return done.error();
  if (zip.directoryProblem().empty() && zip.hasSalvaged()) {
    read.damage.push_back({ArchiveError::Malformed, {"Its directory is wrong"}, {}, {}});
  }
  read.isNewer = *version > kContainerVersion;
  if (const Status done = migrate(read.container, *version, migrations()); !done) return done.error();
  progress.set(1.0);
  return read;
}

}  // namespace

Result<ReadContainer> readContainer(std::string_view bytes, Progress progress) {
  if (bytes.empty()) return Error{ErrorCode::FileEmpty, {}, {}, {}};
  return catchOutOfMemory([&] {
    ZipReader zip(bytes, kLimits, progress);
    return readFrom(zip, progress);
  });
}

}  // namespace handwheel
