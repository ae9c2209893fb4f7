// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

// What lies in a recovery folder: <root>/<session>/ holds the file "lock", and for each autosave <number>.handwheel, a
// container like any other, and <number>.json, which says what it is of.
namespace handwheel {

// What an autosave is of.
struct AutosaveInfo {
  std::string documentId;
  std::string path;  // of the file that the document belongs to, as bytes; empty when it was never saved
  std::string name;  // what its user calls it, UTF-8
  std::string kind;
  bool operator==(const AutosaveInfo&) const = default;
};

// Where autosaves are kept, unless another place is named: in the application's local data.
std::filesystem::path recoveryFolder();

namespace recovery {

inline constexpr const char* kAutosaveEnding = ".handwheel";

std::filesystem::path autosaveFile(const std::filesystem::path& session, std::uint64_t key);
// Beside the autosave.
std::filesystem::path infoFile(std::filesystem::path autosave);

std::string infoText(const AutosaveInfo& info);
// Whatever can be understood; the rest stays empty.
AutosaveInfo parseInfo(std::string_view text);

}  // namespace recovery

}  // namespace handwheel
