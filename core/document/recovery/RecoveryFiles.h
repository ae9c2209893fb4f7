// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/FileTimestamp.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

// Layout of a recovery folder. <root>/<session>/ holds the file "lock", and for each autosave <number>.handwheel, a
// container like any other, and <number>.json, which describes its document; where little has changed since,
// <number>.changes has what did (AutosaveChanges.h), or <number>.damaged if that cannot be read.
namespace handwheel {

// Describes the document that an autosave belongs to.
struct AutosaveInfo {
  std::string documentId;
  std::string path;  // of the file that the document belongs to, as bytes; empty when it was never saved
  std::string name;  // what its user calls it, UTF-8
  std::string kind;
  std::optional<FileTimestamp> stamp = {};  // of that file, as the document was last read from it or written to it
  bool isPartial = false;                   // DocumentFile::wouldLoseDataOnOverwrite()
  bool operator==(const AutosaveInfo&) const = default;
};

// The default folder of autosaves, in the application's local data.
std::filesystem::path recoveryFolder();

namespace recovery {

inline constexpr const char* kAutosaveEnding = ".handwheel";
inline constexpr const char* kDamagedEnding = ".damaged";

// The path of an autosave.
std::filesystem::path autosaveFile(const std::filesystem::path& session, std::uint64_t key);
// The path of an autosave's description, next to it.
std::filesystem::path infoFile(std::filesystem::path autosave);
// The path of what has changed since an autosave, next to it.
std::filesystem::path changesFile(std::filesystem::path autosave);
// Where changes that cannot be read are kept.
std::filesystem::path damagedFile(std::filesystem::path autosave);
// Removes an autosave and its changes; the description stays.
void removeAutosave(const std::filesystem::path& autosave);

// The content of a description file.
std::string infoText(const AutosaveInfo& info);
// Parses a description file; what cannot be understood stays empty.
AutosaveInfo parseInfo(std::string_view text);

}  // namespace recovery

}  // namespace handwheel
