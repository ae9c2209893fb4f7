// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceKind.h"

#include "document/AtomicFile.h"
#include "document/formats/MeshExport.h"
#include "document/workpiece/FinishReport.h"
#include "document/workpiece/ThreadReport.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceFromDrawing.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "document/workpiece/WorkpieceShape.h"
#include "document/workpiece/blobs/TurnedPartBlobs.h"
#include "document/workpiece/target/DrawingExport.h"
#include "document/workpiece/target/TargetBlobs.h"
#include "document/workpiece/target/TargetImport.h"
#include "document/workpiece/target/TargetReport.h"
#include "machining/lathe/LatheCrashJson.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/ProgramToolsJson.h"
#include "mesh/structure/MeshBuilder.h"
#include "nurbs/CylinderDistance.h"
#include "scene/RevolvedGeometry.h"

#include <QtGlobal>
#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr const char *kProgramTools = "program_tools", *kProgramPost = "program_post";

const WorkpieceSnapshot& workpieceOf(const Snapshot& content) {
  return static_cast<const WorkpieceSnapshot&>(content);
}

bool isStepName(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending == ".step" || ending == ".stp";
}

Result<WrittenFile> exportStep(const WorkpieceSnapshot& workpiece, const std::filesystem::path& path,
                               Progress progress) {
  const Result<std::string> bytes = checkedStep(workpiece, progress.part(0.0, 0.9));
  if (!bytes) {
    Error error = bytes.error();
    error.subject = path.string();
    return error;
  }
  const Status written = writeFileAtomically(path, *bytes, progress.part(0.9, 1.0));
  if (!written) return written.error();
  WrittenFile file{bytes->size(), {{QT_TRANSLATE_NOOP("Note", "The file contains one valid solid.")}}};
  for (Note& note : sectionNotes(workpiece)) file.notes.push_back(std::move(note));
  if (workpiece.part && workpiece.part->threads())
    file.notes.push_back({QT_TRANSLATE_NOOP("Note", "Threads are in the file as their envelope, without grooves: %1."),
                          {threadsText(*workpiece.part, workpiece.stock.position)},
                          true});
  return file;
}

// The section of the workpiece with its material in the title block; its name is that of the file.
Result<WrittenFile> exportSection(const WorkpieceSnapshot& workpiece, const std::filesystem::path& path,
                                  Progress progress) {
  const Result<TargetProfile> section = sectionOf(workpiece);
  if (!section) {
    Error error = section.error();
    error.subject = path.string();
    return error;
  }
  DrawingTitle title;
  title.name = path.stem().string();
  title.material = workpiece.material;
  title.tolerance = workpiece.chord;
  title.threads = threadsToDraw(workpiece);
  Result<WrittenFile> drawn = exportDrawing(*section, title, path, progress);
  if (!drawn) return drawn;
  const std::vector<Note> notes = sectionNotes(workpiece);
  drawn->notes.insert(drawn->notes.begin(), notes.begin(), notes.end());
  return drawn;
}

// The mesh of the workpiece.
Result<WrittenFile> exportSurface(const WorkpieceSnapshot& workpiece, const std::filesystem::path& path,
                                  Progress progress) {
  Result<TriangleSoup> soup = placedTriangles(workpiece, progress.part(0.0, 0.15));
  if (!soup) return soup.error();
  const HalfEdgeMesh mesh = buildMesh(*soup, progress.part(0.15, 0.3)).mesh;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const Result<ExportReport> report = exportMesh(mesh, NumberType::Float64, path, progress.part(0.3, 1.0));
  if (!report) return report.error();
  return WrittenFile{report->bytes, notesOn(*report)};
}

}  // namespace

std::string WorkpieceKind::title() const {
  return QT_TRANSLATE_NOOP("DocumentKind", "Workpiece");
}

std::vector<FileFormat> WorkpieceKind::formats() const {
  std::vector<FileFormat> all{{"STEP", {".step", ".stp"}, false, true}};
  for (FileFormat& format : meshFileFormats()) {
    if (!format.writes) continue;
    format.reads = false;
    all.push_back(std::move(format));
  }
  for (FileFormat& format : drawingFormats()) {
    format.reads = format.name != "PDF";
    all.push_back(std::move(format));
  }
  return all;
}

bool WorkpieceKind::recognises(std::string_view head, std::string_view) const {
  return looksLikeDrawing(head);
}

Result<OpenedFile> WorkpieceKind::import(const std::filesystem::path& path, const ReadOptions&,
                                         Progress progress) const {
  return openDrawing(*this, path, progress);
}

Result<WrittenFile> WorkpieceKind::exportTo(const Snapshot& content, const std::filesystem::path& path,
                                            Progress progress) const {
  const auto write = isStepName(path) ? exportStep : isDrawingName(path) ? exportSection : exportSurface;
  Result<WrittenFile> written = write(workpieceOf(content), path, progress);
  if (written) written->isExport = true;
  return written;
}

void WorkpieceKind::save(const Snapshot& content, Container& container) const {
  nlohmann::json& document = (*container.manifest)["document"];
  if (!document.is_object()) document = nlohmann::json::object();
  for (WorkpieceField field : kWorkpieceFields) {
    const Property property = propertyOf(workpieceOf(content), field);
    std::visit([&](const auto& value) { document[property.id] = value; }, property.value);
  }
  writeTurnedPart(workpieceOf(content), container);
  writeTarget(workpieceOf(content), container);
  if (const auto& lathe = workpieceOf(content).lathe) document["lathe"] = toJson(*lathe);
  if (const auto& tools = workpieceOf(content).programTools) document[kProgramTools] = toJson(*tools);
  if (const ProgramPost& post = workpieceOf(content).programPost; post != ProgramPost())
    document[kProgramPost] = toJson(post);
  if (const auto& crashes = workpieceOf(content).crashes) document["crashes"] = crashesToJson(*crashes);
}

Result<SnapshotPointer> WorkpieceKind::load(const Container& container, std::vector<Error>& damage,
                                            Progress progress) const {
  const auto found = container.manifest->find("document");
  if (found == container.manifest->end() || !found->is_object()) {
    return Error{ErrorCode::ElementMalformed, {"document", "it is missing"}, {}, {}};
  }
  WorkpieceSnapshot workpiece;
  for (WorkpieceField field : kWorkpieceFields) {
    const std::string id = propertyOf(workpiece, field).id;
    const nlohmann::json entry = found->value(id, nlohmann::json());
    PropertyValue value = false;  // fits no field
    if (entry.is_number()) value = entry.get<double>();
    if (entry.is_string()) value = entry.get<std::string>();
    const Status checked = checkValue(field, value);
    if (checked) {
      workpiece = withValue(std::move(workpiece), field, value);
    } else {
      damage.push_back(checked.error());
    }
  }
  if (const auto lathe = found->find("lathe"); lathe != found->end()) {
    Result<LatheSetup> setup = latheSetupFrom(*lathe);
    if (setup) workpiece.lathe = std::make_shared<const LatheSetup>(std::move(*setup));
    if (!setup) damage.push_back(setup.error());
  }
  if (ProgramTools tools = programToolsFrom(found->value(kProgramTools, nlohmann::json()), shippedLatheTools(), damage);
      !tools.empty())
    workpiece.programTools = std::make_shared<const ProgramTools>(std::move(tools));
  workpiece.programPost = programPostFrom(found->value(kProgramPost, nlohmann::json()), damage);
  auto part = readTurnedPart(*found, workpiece, container, damage, progress);
  if (!part) return part.error();
  workpiece.part = std::move(part.value());
  workpiece.target = readTarget(*found, container, damage);
  addCrashes(workpiece, crashesFrom(found->value("crashes", nlohmann::json())));
  // An older program kept the crashes of programs there.
  if (const auto turned = found->find("turned"); turned != found->end() && turned->is_object())
    addCrashes(workpiece, crashesFrom(turned->value("crashes", nlohmann::json())));
  return SnapshotPointer(std::make_shared<const WorkpieceSnapshot>(std::move(workpiece)));
}

SnapshotPointer WorkpieceKind::blank() const {
  return std::make_shared<const WorkpieceSnapshot>();
}

std::unique_ptr<Document> WorkpieceKind::make(OpenedFile opened) const {
  return std::make_unique<WorkpieceDocument>(std::move(opened));
}

nlohmann::json WorkpieceKind::describe(const Snapshot& content) const {
  const WorkpieceSnapshot& workpiece = workpieceOf(content);
  nlohmann::json described = {{"diameter", workpiece.stock.diameter},
                              {"length", workpiece.stock.length},
                              {"position", workpiece.stock.position},
                              {"material", workpiece.material},
                              {"chord", workpiece.chord}};
  if (const Result<TargetProfile> section = sectionOf(workpiece))
    described["dimensions"] = dimensionsJson(*section, workpiece.chord);
  if (workpiece.programTools) described[kProgramTools] = toJson(*workpiece.programTools);
  if (workpiece.programPost != ProgramPost()) described[kProgramPost] = toJson(workpiece.programPost);
  if (workpiece.target) {
    described["target"] = {{"source", workpiece.target->source},
                           {"volume", workpiece.target->profile.volume()},
                           {"deviation", deviationJson(deviationOf(workpiece))}};
  }
  if (workpiece.part) {
    const TurnedPart& part = *workpiece.part;
    described["volume"] = part.volume();
    described["area"] = part.profile.area();
    described["passes"] = part.passes.size();
    described["spacing"] = part.profile.spacing();
    described["bored"] = part.profile.isBored();
    if (part.threads()) described["threads"] = threadsJson(part, workpiece.stock.position);
    const std::vector<TurnedSection> pieces = part.section().pieces();
    described["pieces"] = pieces.size();
    if (pieces.size() > 1)
      described["end_piece"] = {{"length", pieces.back().box().sizes().y()}, {"volume", part.volumeOf(pieces.back())}};
    described["finish"] = finishJson(part, workpiece.stock.position);
    return described;
  }
  StockCylinder atOrigin = workpiece.stock;
  atOrigin.position = 0.0;
  const TriangleSoup& soup = *workpiece.mesh->soup();
  described["volume"] = workpiece.stock.volume();
  described["area"] = workpiece.stock.area();
  described["triangles"] = soup.triangles.size();
  described["deviation"] = distanceToCylinder(soup, atOrigin);
  return described;
}

DisplayModel WorkpieceKind::display(const Snapshot& content) const {
  const WorkpieceSnapshot& workpiece = workpieceOf(content);
  if (workpiece.part) {
    DisplayModel turned = displayOf(workpiece.part->surface, workpiece.stock.position);
    showFinish(turned, workpiece.part->profile, workpiece.part->finish);
    showPartedOff(turned, workpiece.part->profile);
    return turned;
  }
  DisplayPart part;
  part.name = "stock";
  part.group = kStockGroup;
  part.soup = workpiece.mesh->soup();
  part.pose.translation().z() = workpiece.stock.position;
  return {{std::move(part)}};
}

GeometryPointer WorkpieceKind::bodyGeometry(const Snapshot& content, std::vector<Note>& notes) const {
  const WorkpieceSnapshot& workpiece = workpieceOf(content);
  const Result<std::vector<TurnedCurves>> pieces = curvesOf(workpiece);
  const bool isThreaded = workpiece.part && workpiece.part->threads();
  if (!pieces || isThreaded || pieces->size() != 1 || !pieces->front().cavities.empty())
    return DocumentKind::bodyGeometry(content, notes);
  const double chord =
      workpiece.part ? std::max(0.5 * workpiece.chord, RevolvedGeometry::kLeastChord) : workpiece.chord;
  auto made = RevolvedGeometry::make(pieces->front().outside, chord);
  return made ? GeometryPointer(std::move(made).value()) : DocumentKind::bodyGeometry(content, notes);
}

}  // namespace handwheel
