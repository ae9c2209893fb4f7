// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace handwheel {

// Size and CRC-32 of bytes, as manifests have them.
struct ByteSum {
  std::uint64_t bytes = 0;
  std::string checksum;
  bool operator==(const ByteSum&) const = default;
};

// What an autosave on the disk holds, so that it need not be written again.
struct StoredAutosave {
  ByteSum file;
  std::map<std::string, ByteSum> blobs;
};

// archive: the bytes of the container.
StoredAutosave storedAutosave(const Container& container, std::string_view archive);

// A container with the blobs that the stored autosave does not have, and a list of the others in its manifest. None
// where that is more than half of it: then a whole autosave takes the place of the stored one.
std::optional<Container> changesSince(const StoredAutosave& stored, const Container& container);

// The container that a stored autosave and its changes make up. None where the changes are damaged, or of another
// autosave than this: one that replaced it is newer than they are.
std::optional<Container> withChanges(std::string_view autosave, std::string_view changes);

// Whether the changes beside an autosave are part of it now; those of another autosave do not count.
enum class JoinedChanges { All, Damaged };

// Writes the changes of an autosave that were stored beside it (recovery::changesFile()) into it. Where they are
// damaged, or it is, it stays without them, and they are moved to recovery::damagedFile(). After a failure all is as it
// was. Errors: those of reading and writing files.
Result<JoinedChanges> joinChanges(const std::filesystem::path& autosave, Progress progress = {});

}  // namespace handwheel
