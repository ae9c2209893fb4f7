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

// Returns the content of a document for a volume. scan: the image that is saved with the volume. pieceCells: see
// VolumeSurface. Errors: VolumeErrors::TooLargeToSave, ImageTooLarge, Cancelled.
Result<std::shared_ptr<const VolumeSnapshot>> snapshotOf(const SparseVolume& volume, const std::string& source,
                                                         Progress progress, std::shared_ptr<const Scan> scan = {},
                                                         const Segment& segment = {},
                                                         int pieceCells = VolumeSurface::kPieceCells);

struct MadeVolume {
  std::shared_ptr<const VolumeSnapshot> volume;
  SurfaceVolume surface;  // result of the conversion; its volume shares its blocks with `volume`
};

// Makes the content of a document from the inside of a surface. voxel: size of a voxel, mm; none: usualVoxel(). Errors:
// the errors of volumeOfSurface(), and VolumeErrors::TooLargeToSave.
Result<MadeVolume> makeVolume(const TriangleSoup& surface, std::optional<double> voxel, const std::string& source,
                              Progress progress, VoxelMethod method = VoxelMethod::Sign,
                              int pieceCells = VolumeSurface::kPieceCells);

// Returns a note on lost walls of a volume that was made from a surface, if there are any.
std::vector<Note> notesOn(const SurfaceVolume& made);

// Returns the content of a document with the built-in skull. The content is shared while it is in use. Otherwise it is
// made, which takes a second; if only pieceCells differs, only the pieces of the surface are made.
std::shared_ptr<const VolumeSnapshot> skullContent(int pieceCells = VolumeSurface::kPieceCells);

// Makes the content of a document from a file or folder of images (ImageFiles.h), or from a VDB file. The volume of an
// image is the region above otsuThreshold(), or that of all labels. The notes state the threshold and the remarks on
// the file. Errors: the errors of the readers and of volumeOfImage(); VolumeErrors::TooLargeToSave, ImageTooLarge.
Result<std::shared_ptr<const VolumeSnapshot>> importVolume(const std::filesystem::path& path, std::vector<Note>& notes,
                                                           Progress progress,
                                                           int pieceCells = VolumeSurface::kPieceCells);
// Returns true if importVolume() may read a file that begins with these bytes.
bool isVolumeFile(std::string_view head);

}  // namespace handwheel
