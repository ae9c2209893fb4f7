// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Container.h"
#include "volume/SparseVolume.h"

#include <nlohmann/json_fwd.hpp>
#include <optional>

// The blocks of a volume in a container. They are in chunks of about a megabyte, named by a folder and four digits.
namespace handwheel {

// The grid of a volume as an object of the manifest: "voxel" and "origin".
nlohmann::json gridOf(const SparseVolume& volume);

// Returns how many there are.
std::size_t writeChunks(const SparseVolume& volume, const std::string& folder, Container& container);

// What was read of chunks: their bytes, and how many are lost or end early.
struct ChunksRead {
  std::size_t bytes = 0, lost = 0;
};

// Adds chunks to a volume, as many as there should be; none: those that are there. Fewer once cancelled.
ChunksRead readChunks(const Container& container, const std::string& folder, std::optional<std::size_t> count,
                      SparseVolume& volume, const Progress& progress);

// The number of chunks in a value of the manifest; none where that makes no sense.
std::optional<std::size_t> chunkCountOf(const nlohmann::json& value);

}  // namespace handwheel
