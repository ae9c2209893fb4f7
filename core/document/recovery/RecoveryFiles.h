// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/FileTimestamp.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

// Layout of a recovery folder. The folder <root>/<session>/ contains the file "lock". For each autosave it contains
// <number>.handwheel, an ordinary container, and <number>.json, which describes the document. If little has changed
// since the container was written, <number>.changes contains the changes (AutosaveChanges.h); changes that cannot be
// read are renamed to <number>.damaged.
namespace handwheel {

// Description of the document that an autosave belongs to.
struct AutosaveInfo {
  std::string documentId;
  std::string path;  // path of the document's file, as bytes; empty if it was never saved
  std::string name;  // name of the document shown to the user, UTF-8
  std::string kind;
  // Stamp of the document's file when the document was last read from it or written to it.
  std::optional<FileTimestamp> stamp = {};
  bool isPartial = false;       // value of DocumentFile::wouldLoseDataOnOverwrite()
  bool hasPrivateName = false;  // value of DocumentFile::hasPrivateName
  bool operator==(const AutosaveInfo&) const = default;
};

// Returns the default root folder of autosaves, in the application's local data.
std::filesystem::path recoveryFolder();

namespace recovery {

inline constexpr const char* kAutosaveEnding = ".handwheel";
inline constexpr const char* kDamagedEnding = ".damaged";

// Returns the path of an autosave.
std::filesystem::path autosaveFile(const std::filesystem::path& session, std::uint64_t key);
// Returns the path of the description of an autosave, next to the autosave.
std::filesystem::path infoFile(std::filesystem::path autosave);
// Returns the path of the changes since an autosave, next to the autosave.
std::filesystem::path changesFile(std::filesystem::path autosave);
// Returns the path for changes of an autosave that cannot be read.
std::filesystem::path damagedFile(std::filesystem::path autosave);
// Removes an autosave and its changes; the description stays.
void removeAutosave(const std::filesystem::path& autosave);

// Returns the content of a description file.
std::string infoText(const AutosaveInfo& info);
// Parses a description file. Parts that cannot be understood stay empty.
AutosaveInfo parseInfo(std::string_view text);

}  // namespace recovery

}  // namespace handwheel
