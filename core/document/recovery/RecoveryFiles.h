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
// container like any other, and <number>.json, which describes its document; if little has changed since,
// <number>.changes holds the changes (AutosaveChanges.h), or <number>.damaged if they cannot be read.
namespace handwheel {

// Description of the document that an autosave belongs to.
struct AutosaveInfo {
  std::string documentId;
  std::string path;  // path of the document's file, as bytes; empty if it was never saved
  std::string name;  // name shown to the user, UTF-8
  std::string kind;
  std::optional<FileTimestamp> stamp =
      {};                  // stamp of that file when the document was last read from it or written to it
  bool isPartial = false;  // DocumentFile::wouldLoseDataOnOverwrite()
  bool operator==(const AutosaveInfo&) const = default;
};

// Returns the default folder of autosaves, in the application's local data.
std::filesystem::path recoveryFolder();

namespace recovery {

inline constexpr const char* kAutosaveEnding = ".handwheel";
inline constexpr const char* kDamagedEnding = ".damaged";

// Returns the path of an autosave.
std::filesystem::path autosaveFile(const std::filesystem::path& session, std::uint64_t key);
// Returns the path of an autosave's description, next to it.
std::filesystem::path infoFile(std::filesystem::path autosave);
// Returns the path of the changes since an autosave, next to it.
std::filesystem::path changesFile(std::filesystem::path autosave);
// Returns the path for changes that cannot be read.
std::filesystem::path damagedFile(std::filesystem::path autosave);
// Removes an autosave and its changes; the description stays.
void removeAutosave(const std::filesystem::path& autosave);

// Returns the content of a description file.
std::string infoText(const AutosaveInfo& info);
// Parses a description file; parts that cannot be understood stay empty.
AutosaveInfo parseInfo(std::string_view text);

}  // namespace recovery

}  // namespace handwheel
