// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeMaking.h"

#include "base/NumberText.h"
#include "document/Container.h"
#include "document/FileBytes.h"
#include "document/ThinNotes.h"
#include "document/volume/ImageFiles.h"
#include "volume/VolumeErrors.h"
#include "volume/drilling/Skull.h"
#include "volume/image/ImageHistogram.h"
#include "volume/image/ImageLabels.h"
#include "volume/image/ImageToVolume.h"
#include "volume/image/VolumeToImage.h"
#include "volume/vdb/VdbFile.h"

#include <QtGlobal>
#include <limits>
#include <mutex>

namespace handwheel {

namespace {

// Default range of an image's values for material.
ValueRange usualRange(const ImageVolume& image, const ImageHistogram& histogram, std::vector<Note>& notes) {
  if (!image.labels().empty()) {
    notes.push_back({QT_TRANSLATE_NOOP("Note",
                                       "The image is a map of labels (%1): all of them are taken as material. Choose "
                                       "others in the panel Segmentation or with 'handwheel segment'."),
                     {std::to_string(image.labels().size())}});
    return rangeOfLabels(image);
  }
  const double threshold = otsuThreshold(histogram);
  notes.push_back({QT_TRANSLATE_NOOP("Note",
                                     "Values from %1 upwards are taken as material (Otsu's threshold). Choose any "
                                     "other range in the panel Segmentation or with 'handwheel segment'."),
                   {roundedText(threshold, 4)}});
  return {threshold, std::numeric_limits<double>::infinity()};
}

Result<SparseVolume> volumeOfVdb(const std::filesystem::path& path, std::vector<Note>& notes, Progress progress) {
  const Result<std::string> bytes = readFileBytes(path, progress.part(0.0, 0.2));
  if (!bytes) return bytes.error();
  Result<VdbVolume> read = readVdb(*bytes, progress.part(0.2, 1.0));
  if (!read) return read.error();
  if (read->isFog)
    notes.push_back(
        {QT_TRANSLATE_NOOP("Note", "The file contains densities: densities above 0.5 are taken as material.")});
  if (read->otherGrids > 0)
    notes.push_back(
        {QT_TRANSLATE_NOOP("Note", "Other grids of the file were ignored (%1)."), {std::to_string(read->otherGrids)}});
  return std::move(read->volume);
}

// Returns the memory of an image in a document when all of it is painted.
double mostBytes(const ImageVolume& image) {
  double bricks = 1.0;
  for (const int n : Segment::bricksOf(image.grid().size)) bricks *= n;
  return static_cast<double>(image.bytes()) + bricks * (sizeof(SegmentBrick) + sizeof(std::uint16_t));
}

struct OpenedImage {
  SparseVolume volume;
  std::shared_ptr<const Scan> scan;  // null: the image is a volume already
  ValueRange range;
};

Result<OpenedImage> openImage(const std::filesystem::path& path, std::vector<Note>& notes, Progress progress) {
  Result<ImageFile> file = readImageFile(path, progress.part(0.0, 0.6));
  if (!file) return file.error();
  const std::vector<Note> remarks = notesOn(file->remarks);
  notes.insert(notes.end(), remarks.begin(), remarks.end());
  const bool isDistance = file->content == kSignedDistance;
  std::shared_ptr<Scan> scan;
  ValueRange range{-std::numeric_limits<double>::infinity(), 0.0};
  if (!isDistance) {
    ImageHistogram histogram = histogramOf(file->image);
    range = usualRange(file->image, histogram, notes);
    scan = std::make_shared<Scan>(Scan{std::move(file->image), std::move(histogram)});
  }
  Result<SparseVolume> volume =
      volumeOfImage(scan ? scan->image : file->image, range, std::nullopt, progress.part(0.6, 1.0));
  if (!volume) return volume.error();
  return OpenedImage{std::move(*volume), std::move(scan), range};
}

}  // namespace

Result<std::shared_ptr<const VolumeSnapshot>> snapshotOf(const SparseVolume& volume, const std::string& source,
                                                         Progress progress, std::shared_ptr<const Scan> scan,
                                                         const Segment& segment, int pieceCells) {
  constexpr double kMost = 0.95 * static_cast<double>(kLargestContainer);
  const auto megabytes = [](double bytes) { return roundedText(bytes / 1e6, 3); };
  const auto bytes = static_cast<double>(volume.bytes());
  if (bytes > kMost)
    return Error{
        VolumeErrors::TooLargeToSave, {roundedText(volume.voxel()), megabytes(bytes), megabytes(kMost)}, {}, {}};
  if (const double image = scan ? mostBytes(scan->image) : 0.0; bytes + image > kMost)
    return Error{VolumeErrors::ImageTooLarge, {megabytes(image), megabytes(bytes), megabytes(kMost)}, {}, {}};
  auto snapshot = std::make_shared<VolumeSnapshot>();
  snapshot->volume = volume;
  snapshot->surface = VolumeSurface(volume, progress, pieceCells);
  snapshot->source = source;
  if (scan) snapshot->segment = segment;
  snapshot->madeFrom = snapshot->segment;
  snapshot->scan = std::move(scan);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return std::shared_ptr<const VolumeSnapshot>(std::move(snapshot));
}

std::shared_ptr<const VolumeSnapshot> skullContent(int pieceCells) {
  static std::mutex mutex;
  static std::weak_ptr<const VolumeSnapshot> made;
  const std::lock_guard lock(mutex);
  const auto kept = made.lock();
  if (kept && kept->surface.pieceCells() == pieceCells) return kept;
  auto snapshot = std::make_shared<VolumeSnapshot>();
  snapshot->volume = kept ? kept->volume : shippedSkull();
  snapshot->surface = VolumeSurface(snapshot->volume, {}, pieceCells);
  made = snapshot;
  return snapshot;
}

Result<MadeVolume> makeVolume(const TriangleSoup& surface, std::optional<double> voxel, const std::string& source,
                              Progress progress, VoxelMethod method, int pieceCells) {
  Result<SurfaceVolume> made =
      volumeOfSurface(surface, voxel.value_or(usualVoxel(surface)), method, progress.part(0.0, 0.7));
  if (!made) return made.error();
  Result<std::shared_ptr<const VolumeSnapshot>> snapshot =
      snapshotOf(made->volume, source, progress.part(0.7, 1.0), {}, {}, pieceCells);
  if (!snapshot) return snapshot.error();
  return MadeVolume{std::move(*snapshot), std::move(*made)};
}

std::vector<Note> notesOn(const SurfaceVolume& made) {
  std::vector<Note> notes;
  if (const double lost = 1.0 - made.nearShare; lost > kThinShare)
    notes.push_back({QT_TRANSLATE_NOOP("Note",
                                       "Walls thinner than a voxel (%1 mm) were lost: %2 % of the surface is farther "
                                       "than a voxel from the surface of the volume. Choose smaller voxels."),
                     {roundedText(made.volume.voxel()), roundedText(100.0 * lost, 2)}});
  const std::vector<Note> thin = notesOnThinParts(thinFigures(made.thin, ThinKind::Walls, made.volume),
                                                  thinFigures(made.thin, ThinKind::Gaps, made.volume));
  notes.insert(notes.end(), thin.begin(), thin.end());
  return notes;
}

Result<std::shared_ptr<const VolumeSnapshot>> importVolume(const std::filesystem::path& path, std::vector<Note>& notes,
                                                           Progress progress, int pieceCells) {
  std::error_code ignored;
  const bool isFolder = std::filesystem::is_directory(path, ignored);
  const Result<std::string> head = isFolder ? std::string() : readFileHead(path);
  if (!head) return head.error();
  const Progress reading = progress.part(0.0, 0.7);
  if (looksLikeVdb(*head)) {
    const Result<SparseVolume> volume = volumeOfVdb(path, notes, reading);
    if (!volume) return volume.error();
    return snapshotOf(*volume, sourceName(path), progress.part(0.7, 1.0), {}, {}, pieceCells);
  }
  const Result<OpenedImage> image = openImage(path, notes, reading);
  if (!image) return image.error();
  return snapshotOf(image->volume, sourceName(path), progress.part(0.7, 1.0), image->scan, Segment(image->range),
                    pieceCells);
}

bool isVolumeFile(std::string_view head) {
  return looksLikeVdb(head) || looksLikeImage(head);
}

}  // namespace handwheel
