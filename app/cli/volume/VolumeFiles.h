// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"
#include "document/volume/VolumeSnapshot.h"
#include "volume/HybridPart.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace handwheel {

class MemoryNotice;

// Adds the last options of all commands on volumes: --partial, --json and --help.
void addVolumeOptions(std::vector<OptionSpec>& options);

// Returns the content of a document that is a volume, or null for any other kind.
std::shared_ptr<const VolumeSnapshot> volumeIn(const OpenedFile& opened);

// Returns the material of a document: its volume, or the inside of its surface in voxels. voxel: size of a voxel, mm;
// none: usualVoxel(). alignedTo: see volumeOfSurface(). Returns the errors of volumeOfSurface() and
// MemoryNotice::begin(), with the path.
Result<SparseVolume> materialOf(const OpenedFile& opened, const std::filesystem::path& path,
                                std::optional<double> voxel, const std::optional<Vec3>& alignedTo, MemoryNotice& notice,
                                Progress progress);

// Returns the inside of a document's surface as a hybrid part. voxel: size of a voxel, mm. Returns the errors of
// HybridPart::of(), with the path.
Result<HybridPart> hybridOf(const OpenedFile& opened, const std::filesystem::path& path, double voxel,
                            Progress progress);

// Checks that a volume, or its surface as a mesh, can be written under this name. Returns the error of unknownEnding().
Status canWriteVolume(const std::filesystem::path& output, const DocumentKinds& kinds);

// Writes a new document of a volume, or its surface as a mesh. input, inputFile: the source file and its properties.
// Errors: VolumeErrors::NothingLeft if the volume is empty, and the errors of snapshotOf() and saveDocument().
Result<WrittenFile> writeVolume(const SparseVolume& volume, const std::filesystem::path& input,
                                const DocumentFile& inputFile, const std::filesystem::path& output,
                                const DocumentKinds& kinds, Progress progress);

}  // namespace handwheel
