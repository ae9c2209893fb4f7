// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/VolumeFiles.h"

#include "cli/MemoryNotice.h"
#include "cli/volume/OutputName.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/VolumeMaking.h"
#include "volume/VolumeErrors.h"

namespace handwheel {

void addVolumeOptions(std::vector<OptionSpec>& options) {
  options.push_back({"partial", 0, "", "Read the undamaged part of a damaged file"});
  options.push_back({"json", 0, "", "Print the figures as one line of JSON"});
  options.push_back({"help", 'h', "", "Show this help"});
}

std::shared_ptr<const VolumeSnapshot> volumeIn(const OpenedFile& opened) {
  return std::dynamic_pointer_cast<const VolumeSnapshot>(opened.content);
}

Result<SparseVolume> materialOf(const OpenedFile& opened, const std::filesystem::path& path,
                                std::optional<double> voxel, const std::optional<Vec3>& alignedTo, MemoryNotice& notice,
                                Progress progress) {
  if (const auto volume = volumeIn(opened)) return volume->volume;
  const TriangleSoup surface = placedSoup(opened.kind->display(*opened.content));
  const double edge = voxel.value_or(usualVoxel(surface));
  const Status begun = notice.begin(surface, edge);
  Result<SurfaceVolume> made = begun ? volumeOfSurface(surface, edge, progress, alignedTo) : begun.error();
  if (made) return std::move(made->volume);
  Error error = made.error();
  error.subject = path.string();
  return error;
}

Result<HybridPart> hybridOf(const OpenedFile& opened, const std::filesystem::path& path, double voxel,
                            Progress progress) {
  Result<HybridPart> part = HybridPart::of(placedSoup(opened.kind->display(*opened.content)), voxel, progress);
  if (part) return part;
  Error error = part.error();
  error.subject = path.string();
  return error;
}

Status canWriteVolume(const std::filesystem::path& output, const DocumentKinds& kinds) {
  const auto endings = writtenEndings(kinds.withId("volume")->formats());
  if (!hasOneOf(output, endings) && !isContainerName(output)) return unknownEnding(output, endings);
  return Done{};
}

Result<WrittenFile> writeVolume(const SparseVolume& volume, const std::filesystem::path& input,
                                const DocumentFile& inputFile, const std::filesystem::path& output,
                                const DocumentKinds& kinds, Progress progress) {
  if (volume.isEmpty()) return Error{VolumeErrors::NothingLeft, {}, {}, {}};
  const auto snapshot = snapshotOf(volume, sourceName(input), progress.part(0.0, 0.5));
  if (!snapshot) return snapshot.error();
  DocumentFile file;
  file.displayUnit = inputFile.displayUnit;
  return saveDocument(*kinds.withId("volume"), file, **snapshot, output, progress.part(0.5, 1.0));
}

}  // namespace handwheel
