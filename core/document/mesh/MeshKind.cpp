// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/MeshKind.h"

#include "mesh/structure/MeshErrors.h"

#include "base/NumberText.h"
#include "document/container/Blobs.h"
#include "document/formats/MeshExport.h"
#include "document/mesh/LevelBlobs.h"
#include "document/mesh/MeshBlobs.h"
#include "document/mesh/MeshDocument.h"
#include "document/mesh/SubdivisionLevelStore.h"
#include "mesh/structure/MeshErrors.h"

#include <QString>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

const std::string kTurnedFaces = "mesh/turned_faces";

const MeshSnapshot& meshOf(const Snapshot& content) {
  return static_cast<const MeshSnapshot&>(content);
}

bool hasLevels(const MeshSnapshot& mesh) {
  return mesh.levels && isSameVersion(mesh.levels->mesh(), mesh.mesh.mesh);
}

// No format of meshes holds these.
std::vector<Note> lossesOf(const MeshSnapshot& mesh) {
  std::vector<Note> losses;
  const auto& loops = mesh.mesh.defects->loops;
  const auto kept = std::count_if(loops.begin(), loops.end(), [&mesh](const BoundaryLoop& loop) {
    return mesh.keptOpen.contains(keyOf(mesh.mesh.mesh, loop));
  });
  if (kept > 0) {
    losses.push_back({QT_TRANSLATE_NOOP("Note", "The marks of holes to keep open are not in this file (%1 marked)."),
                      {std::to_string(kept)},
                      true});
  }
  if (hasLevels(mesh))
    losses.push_back(
        {QT_TRANSLATE_NOOP("Note", "The coarser levels of the sculpted patch are not in this file."), {}, true});
  return losses;
}

}  // namespace

std::string MeshKind::title() const {
  return QT_TRANSLATE_NOOP("DocumentKind", "Mesh");
}

std::vector<FileFormat> MeshKind::formats() const {
  return meshFileFormats();
}

bool MeshKind::recognises(std::string_view, std::string_view) const {
  return true;
}

std::shared_ptr<MeshSnapshot> meshSnapshotOf(const MeshFile& file, double nearWeld, Progress progress) {
  BuiltMesh built = buildMesh(file.soup, progress.part(0.0, 0.4));
  auto snapshot = std::make_shared<MeshSnapshot>();
  if (const std::vector<Face>& turned = built.report.reversedFaces; !turned.empty()) {
    HalfEdgeMesh asInFile = built.mesh;
    reverseFaces(asInFile, turned, progress.part(0.4, 0.5));
    snapshot->asInFile =
        std::make_shared<const InspectedMesh>(inspected(std::move(asInFile), nearWeld, progress.part(0.5, 0.7)));
  }
  snapshot->build = std::make_shared<const BuildReport>(std::move(built.report));
  const double from = snapshot->asInFile ? 0.7 : 0.4;
  snapshot->mesh = inspected(std::move(built.mesh), nearWeld, progress.part(from, 1.0));
  snapshot->numbers = file.numbers;
  return snapshot;
}

Result<OpenedFile> MeshKind::import(const std::filesystem::path& path, const ReadOptions& options,
                                    Progress progress) const {
  const ReadOptions own{.partial = options.partial, .stepChord = m_stepChord};
  const Result<MeshFile> file = readMeshFile(path, own, progress.part(0.0, 0.5));
  if (!file) return file.error();
  OpenedFile opened;
  opened.kind = this;
  opened.file.damage = file->damage;
  opened.file.unlistedDamage = file->unlistedDamage;
  opened.file.lost = file->lost;
  opened.file.lostOther = file->lostOther;
  opened.file.hasUnit = file->hasUnit;
  opened.file.notes = file->notes;
  opened.content = meshSnapshotOf(*file, m_nearWeld, progress.part(0.5, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return opened;
}

Result<SnapshotPointer> MeshKind::ofSurface(const TriangleSoup& surface, const std::string&, Progress progress) const {
  if (surface.triangles.empty()) return Error{MeshError::NoTriangles, {}, {}, {}};
  MeshFile file;
  file.soup = surface;
  file.numbers = NumberType::Float64;
  SnapshotPointer content = meshSnapshotOf(file, m_nearWeld, progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return content;
}

Result<WrittenFile> MeshKind::exportTo(const Snapshot& content, const std::filesystem::path& path,
                                       Progress progress) const {
  const MeshSnapshot& mesh = meshOf(content);
  const Result<ExportReport> report = exportMesh(mesh.mesh.mesh, mesh.numbers, path, progress);
  if (!report) return report.error();
  WrittenFile written{report->bytes, notesOn(*report)};
  if (report->roundingMove > 0.0) {
    written.notes.push_back({QT_TRANSLATE_NOOP("Note",
                                               "The single precision of the format moved vertices by up to %1 mm; the "
                                               "number of self-intersections may change by that."),
                             {roundedText(report->roundingMove)}});
  }
  for (Note& loss : lossesOf(mesh)) written.notes.push_back(std::move(loss));
  return written;
}

void MeshKind::save(const Snapshot& content, Container& container) const {
  const MeshSnapshot& mesh = meshOf(content);
  const std::vector<Face>& turned = mesh.build->reversedFaces;
  nlohmann::json& document = (*container.manifest)["document"];
  document["numbers"] = mesh.numbers == NumberType::Float32 ? "float32" : "float64";
  document["kept_open"] = mesh.keptOpen;
  document["turned_faces"] = turned.size();
  for (const FidelitySetting& setting : {fillMethodSetting(), fillContinuitySetting()}) {
    const auto chosen = mesh.fillChoice.overrides().find(setting.id);
    if (chosen != mesh.fillChoice.overrides().end()) document["fill"][setting.id] = textOf(setting, chosen->second);
  }
  writeArray<std::uint32_t>(container, kTurnedFaces, turned);
  writeMeshBlobs(mesh.mesh.mesh, container);
  writeLevelBlobs(hasLevels(mesh) ? mesh.levels.get() : nullptr, container);
}

namespace {

std::set<Vertex> keptOpenOf(const nlohmann::json& document, std::size_t vertices) {
  std::set<Vertex> keys;
  const auto found = document.find("kept_open");
  if (found == document.end() || !found->is_array()) return keys;
  for (const nlohmann::json& entry : *found) {
    if (entry.is_number_unsigned() && entry.get<std::uint64_t>() < vertices) keys.insert(entry.get<Vertex>());
  }
  return keys;
}

// Words of later versions are ignored.
FidelityValues fillChoiceOf(const nlohmann::json& document) {
  FidelityValues choice;
  const nlohmann::json fill = document.value("fill", nlohmann::json::object());
  if (!fill.is_object()) return choice;
  for (const FidelitySetting& setting : {fillMethodSetting(), fillContinuitySetting()}) {
    const nlohmann::json word = fill.value(setting.id, nlohmann::json());
    const auto value = valueOf(setting, word.is_string() ? word.get<std::string>() : std::string());
    if (value) (void)choice.set(setting, *value);
  }
  return choice;
}

std::vector<Face> reversedFacesOf(const nlohmann::json& document, const Container& container,
                                  const HalfEdgeMesh& mesh) {
  const nlohmann::json count = document.value("turned_faces", nlohmann::json());
  if (!count.is_number_unsigned()) return {};
  std::vector<Face> faces = readArray<std::uint32_t>(container, kTurnedFaces, count.get<std::uint64_t>()).values;
  std::erase_if(faces, [&](Face f) { return f >= mesh.faceSlots() || !mesh.isLive(f); });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

Result<SnapshotPointer> MeshKind::load(const Container& container, std::vector<Error>& damage,
                                       Progress progress) const {
  const auto found = container.manifest->find("document");
  if (found == container.manifest->end() || !found->is_object()) {
    return Error{ErrorCode::ElementMalformed, {"document", "it is missing"}, {}, {}};
  }
  Result<LoadedMesh> loaded = readMeshBlobs(*found, container, damage, progress.part(0.0, 0.4));
  if (!loaded) return loaded.error();
  auto snapshot = std::make_shared<MeshSnapshot>();
  BuildReport report = std::move(loaded->report);
  if (loaded->isWhole) {
    snapshot->keptOpen = keptOpenOf(*found, loaded->mesh.vertexSlots());
    report.reversedFaces = reversedFacesOf(*found, container, loaded->mesh);
  } else if (!keptOpenOf(*found, kNone).empty()) {
    damage.push_back({ErrorCode::ElementMalformed, {"kept_open", "its loops cannot be identified any more"}, {}, {}});
  }
  snapshot->levels =
      readLevelBlobs(*found, container, loaded->isWhole ? &loaded->mesh : nullptr, damage, progress.part(0.4, 0.5));
  snapshot->build = std::make_shared<const BuildReport>(std::move(report));
  snapshot->fillChoice = fillChoiceOf(*found);
  snapshot->mesh = inspected(std::move(loaded->mesh), m_nearWeld, progress.part(0.5, 1.0));
  snapshot->numbers =
      found->value("numbers", nlohmann::json()) == "float32" ? NumberType::Float32 : NumberType::Float64;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  return SnapshotPointer(snapshot);
}

std::unique_ptr<Document> MeshKind::make(OpenedFile opened) const {
  return std::make_unique<MeshDocument>(std::move(opened));
}

nlohmann::json MeshKind::describe(const Snapshot& content) const {
  const MeshSnapshot& mesh = meshOf(content);
  const Defects& defects = *mesh.mesh.defects;
  return {{"triangles", mesh.mesh.mesh.liveFaceCount()},
          {"boundary_loops", defects.loops.size()},
          {"non_manifold_edges", defects.nonManifoldEdges.size()},
          {"parts", defects.components.size()}};
}

DisplayModel MeshKind::display(const Snapshot& content) const {
  DisplayPart part;
  part.name = "mesh";
  part.soup = std::make_shared<const TriangleSoup>(meshOf(content).mesh.mesh.compact().soup);
  return {{std::move(part)}};
}

}  // namespace handwheel
