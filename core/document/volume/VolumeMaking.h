// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Note.h"
#include "document/volume/VolumeSnapshot.h"
#include "volume/SurfaceDensity.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace handwheel {

// The content of a document made of a volume. scan: the image that is saved with it. pieceCells: as that of
// VolumeSurface, here and below. Errors: VolumeErrors::TooLargeToSave, ImageTooLarge, Cancelled.
Result<std::shared_ptr<const VolumeSnapshot>> snapshotOf(const SparseVolume& volume, const std::string& source,
                                                         Progress progress, std::shared_ptr<const Scan> scan = {},
                                                         const Segment& segment = {},
                                                         int pieceCells = VolumeSurface::kPieceCells);

struct MadeVolume {
  std::shared_ptr<const VolumeSnapshot> volume;
  SurfaceVolume surface;  // what became of the surface; its volume shares the blocks
};

// The content of a document of what a surface encloses. voxel: mm; none: the usual one. Errors: those of
// volumeOfSurface(), and VolumeErrors::TooLargeToSave.
Result<MadeVolume> makeVolume(const TriangleSoup& surface, std::optional<double> voxel, const std::string& source,
                              Progress progress, VoxelMethod method = VoxelMethod::Sign,
                              int pieceCells = VolumeSurface::kPieceCells);

// What there is to say of a volume that was made of a surface: walls that were lost.
std::vector<Note> notesOn(const SurfaceVolume& made);

// The content of a document of the skull that ships. It is made when nobody holds it, which takes a second; its pieces
// are, when somebody holds it with others.
std::shared_ptr<const VolumeSnapshot> skullContent(int pieceCells = VolumeSurface::kPieceCells);

// The content of a document of a file or folder of images (ImageFiles.h), or of VDB. An image becomes what is above the
// threshold that parts it best (otsuThreshold()), which is a note, as is what there is to say of the file. Errors:
// those of the readers and of volumeOfImage(); VolumeErrors::TooLargeToSave, ImageTooLarge.
Result<std::shared_ptr<const VolumeSnapshot>> importVolume(const std::filesystem::path& path, std::vector<Note>& notes,
                                                           Progress progress,
                                                           int pieceCells = VolumeSurface::kPieceCells);
// Whether the first bytes are those of such a file.
bool isVolumeFile(std::string_view head);

}  // namespace handwheel
