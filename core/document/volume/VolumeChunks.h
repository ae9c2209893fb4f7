// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "volume/SparseVolume.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

// The blocks of a volume in a container. Chunks of about a megabyte contain them, named by a folder and four digits.
namespace handwheel {

// Returns the grid of a volume as an object of the manifest: "voxel" and "origin".
nlohmann::json gridOf(const SparseVolume& volume);

// Writes the chunks of a volume, and returns their number.
std::size_t writeChunks(const SparseVolume& volume, const std::string& folder, Container& container);

// The result of reading chunks: their size in bytes, and the number of chunks that were missing or truncated.
struct ChunksRead {
  std::size_t bytes = 0, lost = 0;
};

// Adds chunks to a volume. count: the expected number; none: all chunks of the folder. If cancelled, adds fewer.
ChunksRead readChunks(const Container& container, const std::string& folder, std::optional<std::size_t> count,
                      SparseVolume& volume, const Progress& progress);

// Returns the number of chunks in a value of the manifest, or nothing if the value is malformed.
std::optional<std::size_t> chunkCountOf(const nlohmann::json& value);

}  // namespace handwheel
