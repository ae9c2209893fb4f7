// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Container.h"

#include "document/FileBytes.h"
#include "document/container/ContainerLayout.h"

#include <cassert>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

using namespace layout;
using nlohmann::json;

json blobTable(const Container& container) {
  json table = json::object();
  for (const auto& [name, bytes] : container.blobs) {
    assert(isBlobName(name));
    table[name] = {{"bytes", bytes.size()}, {"crc32", checksumText(bytes)}};
  }
  return table;
}

std::string manifestText(const Container& container) {
  json manifest = *container.manifest;
  manifest["handwheel"]["format"] = kContainerVersion;
  manifest["handwheel"]["program"] = HANDWHEEL_VERSION;
  manifest["blobs"] = blobTable(container);
  // File names need not be UTF-8; a document is not lost for that reason.
  return manifest.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<std::string> writeEntries(const Container& container, Compression compression, Progress progress) {
  const std::string manifest = manifestText(container);
  if (manifest.size() > kLargestManifest) return tooLarge("bytes", manifest.size(), kLargestManifest);
  std::vector<ZipEntry> entries{{kManifest, manifest}};
  for (const auto& [name, bytes] : container.blobs) entries.push_back({name, bytes});
  entries.push_back({kManifestCopy, manifest});
  if (entries.size() >= kLimits.entries) return tooLarge("entries", entries.size(), kLimits.entries);
  std::uint64_t total = 0;
  for (const ZipEntry& entry : entries) total += entry.bytes.size();
  if (total > kLargestContainer) return tooLarge("bytes", total, kLargestContainer);
  Result<std::string> archive = writeZip(entries, compression, progress);
  // An archive with such a compression ratio would be rejected as a decompression bomb.
  if (archive && total > kLimits.budget(archive->size())) return writeZip(entries, Compression::None, progress);
  return archive;
}

}  // namespace

Container::Container() : manifest(std::make_unique<json>(json::object())) {}
Container::Container(const Container& other)
    : manifest(std::make_unique<json>(*other.manifest)), blobs(other.blobs), folder(other.folder) {}
Container::Container(Container&& other) noexcept = default;
Container& Container::operator=(const Container& other) {
  return *this = Container(other);
}
Container& Container::operator=(Container&& other) noexcept = default;
Container::~Container() = default;

Result<std::string> writeContainer(const Container& container, Compression compression, Progress progress) {
  return catchOutOfMemory([&] { return writeEntries(container, compression, progress); });
}

bool looksLikeContainer(std::string_view bytes) {
  constexpr std::size_t kNameInHeader = 30;
  const auto hasManifestAt = [&](std::size_t header) {
    return bytes.size() > header + kNameInHeader && bytes.substr(header + kNameInHeader).starts_with(kManifest);
  };
  if (hasManifestAt(0)) return true;  // even if the bytes before it are damaged
  constexpr std::string_view kLocalHeader("PK\3\4", 4);
  if (!bytes.starts_with(kLocalHeader)) return false;
  // The archive was unpacked and packed again.
  bytes = bytes.substr(0, kFileHead);
  for (std::size_t at = 0; at != std::string_view::npos; at = bytes.find(kLocalHeader, at + 1)) {
    if (hasManifestAt(at)) return true;
  }
  return false;
}

}  // namespace handwheel
