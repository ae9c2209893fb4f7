// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace handwheel {

// The size and the CRC-32 checksum of some bytes. The checksum has the form that container manifests use.
struct ByteSum {
  std::uint64_t bytes = 0;
  std::string checksum;
  bool operator==(const ByteSum&) const = default;
};

// The content of an autosave on the disk. Later autosaves write only the parts that differ from it.
struct StoredAutosave {
  ByteSum file;
  std::map<std::string, ByteSum> blobs;
};

// Returns the content of an autosave. archive: the bytes of the container.
StoredAutosave storedAutosave(const Container& container, std::string_view archive);

// Returns a container with the blobs that the stored autosave does not have; its manifest lists the blobs that the
// autosave has. Returns nothing if the new blobs are more than half of the autosave or of the container, or if all
// blobs are new: a whole autosave then replaces the stored one.
std::optional<Container> changesSince(const StoredAutosave& stored, const Container& container);

// Combines a stored autosave and its changes. Returns nothing if one of them is damaged, or if the changes belong to
// another autosave than this one. An autosave that has replaced the one they belong to is newer than they are.
std::optional<Container> withChanges(std::string_view autosave, std::string_view changes);

// The result of joining an autosave with the changes stored beside it. Changes that belong to another autosave are
// ignored and count as All.
enum class JoinedChanges { All, Damaged };

// Writes the changes that were stored beside an autosave (recovery::changesFile()) into the autosave. If the changes or
// the autosave are damaged, the autosave stays as it is, and the changes are moved to recovery::damagedFile(). A
// failure leaves everything unchanged. Errors: those of reading and writing files.
Result<JoinedChanges> joinChanges(const std::filesystem::path& autosave, Progress progress = {});

}  // namespace handwheel
