// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/NewerFile.h"

#include "base/JsonText.h"
#include "document/Container.h"
#include "document/FileBytes.h"
#include "document/container/ContainerLayout.h"
#include "document/container/ZipReader.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

// Returns the version in the manifest, or its copy; 0 if there is none.
std::uint64_t versionIn(std::string_view bytes) {
  ZipReader zip(bytes, layout::kLimits, {});
  for (const std::string& name : {layout::kManifest, layout::kManifestCopy}) {
    const Result<std::string> text = zip.read(name);
    if (!text || text->size() > layout::kLargestManifest) continue;
    const Result<nlohmann::json> manifest = parseJson(*text, name);
    static const nlohmann::json::json_pointer kFormat("/handwheel/format");
    if (!manifest || !manifest->contains(kFormat)) continue;
    const nlohmann::json& format = (*manifest)[kFormat];
    return format.is_number_unsigned() ? format.get<std::uint64_t>() : 0;
  }
  return 0;
}

}  // namespace

Status checkNotNewer(const std::filesystem::path& path) {
  return layout::catchOutOfMemory([&]() -> Status {
    const Result<std::string> head = readFileHead(path);
    if (!head || !looksLikeContainer(*head)) return Done{};
    const Result<std::string> bytes = readFileBytes(path);
    const std::uint64_t version = bytes ? versionIn(*bytes) : 0;
    if (version <= kContainerVersion) return Done{};
    return Error{
        ErrorCode::VersionNewer, {std::to_string(version), std::to_string(kContainerVersion)}, {}, path.string()};
  });
}

}  // namespace handwheel
