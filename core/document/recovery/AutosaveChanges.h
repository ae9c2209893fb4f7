// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace handwheel {

// Size and CRC-32 of bytes, as in manifests.
struct ByteSum {
  std::uint64_t bytes = 0;
  std::string checksum;
  bool operator==(const ByteSum&) const = default;
};

// The content of an autosave on the disk, so that it need not be written again.
struct StoredAutosave {
  ByteSum file;
  std::map<std::string, ByteSum> blobs;
};

// Returns the content of an autosave. archive: the bytes of the container.
StoredAutosave storedAutosave(const Container& container, std::string_view archive);

// Returns a container with the blobs that the stored autosave does not have, and a list of the others in its manifest.
// None if that is more than half of it: then a whole autosave replaces the stored one.
std::optional<Container> changesSince(const StoredAutosave& stored, const Container& container);

// Combines a stored autosave and its changes. None if the changes are damaged, or belong to another autosave than this:
// one that replaced it is newer than they are.
std::optional<Container> withChanges(std::string_view autosave, std::string_view changes);

// Result of joining the changes beside an autosave with it; those of another autosave are ignored.
enum class JoinedChanges { All, Damaged };

// Writes the changes of an autosave that were stored beside it (recovery::changesFile()) into it. If they or it are
// damaged, it stays without them, and they are moved to recovery::damagedFile(). A failure leaves everything unchanged.
// Errors: those of reading and writing files.
Result<JoinedChanges> joinChanges(const std::filesystem::path& autosave, Progress progress = {});

}  // namespace handwheel
