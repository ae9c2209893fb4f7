// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeKind.h"

#include "document/AtomicFile.h"
#include "document/formats/MeshExport.h"
#include "document/formats/MeshTextValues.h"
#include "document/volume/DrilledHoleBlobs.h"
#include "document/volume/ImageFiles.h"
#include "document/volume/LayerBlobs.h"
#include "document/volume/ScanBlobs.h"
#include "document/volume/VolumeBlobs.h"
#include "document/volume/VolumeDocument.h"
#include "document/volume/VolumeMaking.h"
#include "mesh/structure/MeshBuilder.h"
#include "volume/VolumeShapes.h"
#include "volume/image/NrrdWriter.h"
#include "volume/image/VolumeToImage.h"
#include "volume/surface/VolumeToSurface.h"
#include "volume/vdb/VdbFile.h"

#include <QtGlobal>
#include <limits>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

constexpr const char* kIsOlder = "older_than_segment";
constexpr const char *kVdbEnding = ".vdb", *kNrrdEnding = ".nrrd";

const VolumeSnapshot& volumeOf(const Snapshot& content) {
  return static_cast<const VolumeSnapshot&>(content);
}

bool hasEnding(const std::filesystem::path& path, const char* ending) {
  return equalsIgnoringCase(path.extension().string(), ending);
}

Result<std::string> nrrdBytes(const SparseVolume& volume) {
  const Result<ImageVolume> distances = distancesOf(volume);
  return distances ? Result<std::string>(nrrdOf(*distances, kSignedDistance)) : distances.error();
}

// Adds a warning if the user has chosen another segment, but not yet made its surface.
void warnOfOlder(const VolumeSnapshot& volume, std::vector<Note>& notes) {
  if (!volume.isOlderThanSegment()) return;
  notes.push_back({QT_TRANSLATE_NOOP("Note",
                                     "This file has the surface of an earlier segment. To write that of the current "
                                     "segment, press “Make surface” and save again."),
                   {},
                   true});
}

// Returns notes on the content of a volume that a file of voxels alone does not keep.
std::vector<Note> notesOnVoxels(const VolumeSnapshot& volume) {
  std::vector<Note> lost;
  if (volume.layers)
    lost.push_back(
        {QT_TRANSLATE_NOOP("Note", "The layers are not in this file: they are part of its volume."), {}, true});
  if (volume.mask) lost.push_back({QT_TRANSLATE_NOOP("Note", "The mask is not in this file."), {}, true});
  if (!volume.holes.empty() || volume.tried)
    lost.push_back({QT_TRANSLATE_NOOP("Note", "The records of the holes are not in this file."), {}, true});
  if (volume.scan)
    lost.push_back({QT_TRANSLATE_NOOP("Note", "The image and its segment are not in this file."), {}, true});
  return lost;
}

// A lost range is replaced by the one for the image alone.
void takeScan(std::optional<StoredScan> stored, bool isOlder, VolumeSnapshot& snapshot) {
  if (!stored) return;
  ImageHistogram histogram = histogramOf(stored->image);
  snapshot.segment = stored->segment ? std::move(*stored->segment)
                                     : Segment({otsuThreshold(histogram), std::numeric_limits<double>::infinity()});
  snapshot.madeFrom = isOlder ? std::nullopt : std::optional(snapshot.segment);
  snapshot.scan = std::make_shared<const Scan>(Scan{std::move(stored->image), std::move(histogram)});
}

}  // namespace

std::string VolumeKind::title() const {
  return QT_TRANSLATE_NOOP("DocumentKind", "Volume");
}

std::vector<FileFormat> VolumeKind::formats() const {
  std::vector<FileFormat> all = {{"VDB", {kVdbEnding}},
                                 {"NRRD", {kNrrdEnding}},
                                 {"NRRD header", {".nhdr"}, true, false},
                                 {"MetaImage", {".mhd", ".mha"}, true, false},
                                 {"NIfTI", {".nii", ".nii.gz"}, true, false},
                                 {"DICOM", {".dcm"}, true, false},
                                 {"Raw image", {".raw.json"}, true, false}};
  for (FileFormat& format : meshFileFormats()) {
    if (!format.writes) continue;
    format.reads = false;
    all.push_back(std::move(format));
  }
  return all;
}

bool VolumeKind::recognises(std::string_view head, std::string_view) const {
  return isVolumeFile(head);
}

Result<OpenedFile> VolumeKind::import(const std::filesystem::path& path, const ReadOptions&, Progress progress) const {
  OpenedFile opened;
  opened.kind = this;
  Result<std::shared_ptr<const VolumeSnapshot>> volume = importVolume(path, opened.file.notes, progress, m_pieceCells);
  if (!volume) return volume.error();
  opened.content = std::move(*volume);
  opened.file.title = seriesTitle(path);
  opened.file.hasPrivateName = hasPrivateName(path);
  return opened;
}

bool VolumeKind::hasPrivateName(const std::filesystem::path& path) const {
  return isPrivateName(path);
}

Result<WrittenFile> VolumeKind::exportTo(const Snapshot& content, const std::filesystem::path& path,
                                         Progress progress) const {
  const SparseVolume& volume = volumeOf(content).volume;
  if (hasEnding(path, kVdbEnding) || hasEnding(path, kNrrdEnding)) {
    const Result<std::string> bytes =
        hasEnding(path, kVdbEnding) ? vdbOf(volume, progress.part(0.0, 0.8)) : nrrdBytes(volume);
    if (!bytes) return bytes.error();
    if (const Status written = writeFileAtomically(path, *bytes, progress.part(0.8, 1.0)); !written)
      return written.error();
    std::vector<Note> lost = notesOnVoxels(volumeOf(content));
    warnOfOlder(volumeOf(content), lost);
    const bool isExport = !lost.empty();
    return WrittenFile{bytes->size(), std::move(lost), isExport};
  }
  const TriangleSoup surface = surfaceOf(volume, progress.part(0.0, 0.2));
  const HalfEdgeMesh mesh = buildMesh(surface, progress.part(0.2, 0.4)).mesh;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const Result<ExportReport> report = exportMesh(mesh, NumberType::Float64, path, progress.part(0.4, 1.0));
  if (!report) return report.error();
  std::vector<Note> notes = notesOn(*report);
  warnOfOlder(volumeOf(content), notes);
  return WrittenFile{report->bytes, std::move(notes), true};
}

void VolumeKind::save(const Snapshot& content, Container& container) const {
  writeVolume(volumeOf(content).volume, container);
  (*container.manifest)["document"]["source"] = volumeOf(content).source;
  if (const auto& mask = volumeOf(content).mask) writeMask(*mask, container);
  // Null if there are none, so that unreadable layers are not kept as data of a newer program.
  (*container.manifest)["document"]["layers"] = nullptr;
  if (const auto& layers = volumeOf(content).layers) writeLayers(*layers, volumeOf(content).volume, container);
  writeHoles(volumeOf(content).holes, container);
  if (const auto& tried = volumeOf(content).tried) writeTried(*tried, container);
  if (const auto& scan = volumeOf(content).scan) {
    writeScan(scan->image, volumeOf(content).segment, container);
    (*container.manifest)["document"][kIsOlder] = volumeOf(content).isOlderThanSegment();
  }
}

Result<SnapshotPointer> VolumeKind::load(const Container& container, std::vector<Error>& damage,
                                         Progress progress) const {
  Result<SparseVolume> volume = readVolume(container, damage, progress.part(0.2, 0.5));
  if (!volume) return volume.error();
  auto snapshot = std::make_shared<VolumeSnapshot>();
  snapshot->volume = std::move(*volume);
  snapshot->surface = VolumeSurface(snapshot->volume, progress.part(0.5, 1.0), m_pieceCells);
  const nlohmann::json source = (*container.manifest)["document"].value("source", nlohmann::json());
  if (source.is_string()) snapshot->source = source.get<std::string>();
  snapshot->mask = readMask(container, snapshot->volume, damage);
  snapshot->layers = readLayers(container, snapshot->volume, damage);
  snapshot->holes = readHoles(container, damage);
  snapshot->tried = readTried(container, damage);
  const nlohmann::json isOlder = (*container.manifest)["document"].value(kIsOlder, nlohmann::json());
  takeScan(readScan(container, damage, progress.part(0.0, 0.2)), isOlder == true, *snapshot);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return SnapshotPointer(std::move(snapshot));
}

Result<SnapshotPointer> VolumeKind::ofSurface(const TriangleSoup& surface, const std::string& source,
                                              Progress progress) const {
  Result<MadeVolume> made = makeVolume(surface, std::nullopt, source, progress, VoxelMethod::Sign, m_pieceCells);
  if (!made) return made.error();
  return SnapshotPointer(std::move(made->volume));
}

SnapshotPointer VolumeKind::blank() const {
  constexpr double kRadius = 20.0, kVoxel = 0.2;  // mm
  // Made once for each division: the window asks for it twice.
  static std::mutex mutex;
  static std::map<int, SnapshotPointer> made;
  const std::lock_guard lock(mutex);
  const int cells = m_pieceCells;  // another thread may set it
  SnapshotPointer& known = made[cells];
  if (known) return known;
  auto ball = std::make_shared<VolumeSnapshot>();
  ball->volume = ballOfVoxels(kRadius, kVoxel);
  ball->surface = VolumeSurface(ball->volume, {}, cells);
  return known = std::move(ball);
}

std::unique_ptr<Document> VolumeKind::make(OpenedFile opened) const {
  return std::make_unique<VolumeDocument>(std::move(opened));
}

nlohmann::json VolumeKind::describe(const Snapshot& content) const {
  const VolumeSnapshot& volume = volumeOf(content);
  nlohmann::json described = {{"voxel", volume.volume.voxel()},
                              {"volume", volume.volume.enclosed()},
                              {"blocks", volume.volume.blockCount()},
                              {"bytes", volume.volume.bytes()},
                              {"triangles", volume.surface.triangleCount()},
                              {"source", volume.source},
                              {"holes", volume.holes.size()},
                              {"layers", nlohmann::json::array()}};
  if (!volume.layers) return described;
  for (const ClayLayer& layer : volume.layers->all())
    described["layers"].push_back({{"name", layer.name},
                                   {"strength", layer.strength},
                                   {"on", layer.isOn},
                                   {"blocks", layer.change->blocks().size()}});
  return described;
}

DisplayModel VolumeKind::display(const Snapshot& content) const {
  DisplayModel model;
  DisplayPart part;
  part.name = part.group = "volume";
  part.soup = std::make_shared<const TriangleSoup>(surfaceOf(volumeOf(content).volume));
  part.colour = {0.76f, 0.66f, 0.55f};  // clay
  model.parts.push_back(std::move(part));
  return model;
}

}  // namespace handwheel
