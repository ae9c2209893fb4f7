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

// Adds the options that all commands on volumes end with: --partial, --json and --help.
void addVolumeOptions(std::vector<OptionSpec>& options);

// The content of a document of a volume; null where it is of another kind.
std::shared_ptr<const VolumeSnapshot> volumeIn(const OpenedFile& opened);

// The material of a document: its own volume, or what its surface encloses, in voxels of this edge (mm; none: the usual
// one). alignedTo: as in volumeOfSurface(). Errors: those of volumeOfSurface() and MemoryNotice::begin(), about the
// path.
Result<SparseVolume> materialOf(const OpenedFile& opened, const std::filesystem::path& path,
                                std::optional<double> voxel, const std::optional<Vec3>& alignedTo, MemoryNotice& notice,
                                Progress progress);

// What the surface of a document encloses, with voxels of this edge, mm, where they are asked for. Errors: those of
// HybridPart::of(), about the path.
Result<HybridPart> hybridOf(const OpenedFile& opened, const std::filesystem::path& path, double voxel,
                            Progress progress);

// Whether a volume can be written under this name: as one, or its surface as a mesh. Error: that of unknownEnding().
Status canWriteVolume(const std::filesystem::path& output, const DocumentKinds& kinds);

// Writes a new document of a volume, or its surface as a mesh. input: the file that it was made of, and what is known
// of it. Errors: VolumeErrors::NothingLeft of an empty one; those of snapshotOf() and saveDocument().
Result<WrittenFile> writeVolume(const SparseVolume& volume, const std::filesystem::path& input,
                                const DocumentFile& inputFile, const std::filesystem::path& output,
                                const DocumentKinds& kinds, Progress progress);

}  // namespace handwheel
