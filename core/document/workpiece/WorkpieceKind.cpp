// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceKind.h"

#include "base/Tolerance.h"
#include "document/AtomicFile.h"
#include "document/DocumentErrors.h"
#include "document/formats/MeshExport.h"
#include "document/workpiece/TurnedPartBlobs.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceErrors.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "mesh/structure/MeshBuilder.h"
#include "nurbs/CylinderDistance.h"
#include "nurbs/StepFile.h"
#include "nurbs/Tessellation.h"
#include "scene/RevolvedGeometry.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

const WorkpieceSnapshot& workpieceOf(const Snapshot& content) {
  return static_cast<const WorkpieceSnapshot&>(content);
}

bool isStepName(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending == ".step" || ending == ".stp";
}

Error notAsMeant(const char* what) {
  return {DocumentError::CheckFailed, {what}, {}, {}};
}

// The exact profile of a bar where it stands; of a part a polyline within the chord tolerance.
Result<ProfileCurve> profileOf(const WorkpieceSnapshot& workpiece) {
  if (!workpiece.part) return workpiece.stock.profile();
  std::vector<ProfilePoint> points = workpiece.part->profile.polyline(0.5 * workpiece.chord);
  for (ProfilePoint& p : points) p.y() += workpiece.stock.position;
  return ProfileCurve::polyline(points);
}

// The volume (mm³) of frustums through these points.
double volumeOf(const ProfileCurve& profile) {
  double sum = 0.0;
  const auto arcs = profile.arcs();
  for (const BezierArc& arc : arcs) {
    const ProfilePoint a = arc.start(), b = arc.end();
    sum += (b.y() - a.y()) * (a.x() * a.x() + a.x() * b.x() + b.x() * b.x());
  }
  return M_PI / 3.0 * sum;
}

// The bytes, after another look at what they hold. The profile is made of straight lines.
Result<std::string> checkedStep(const ProfileCurve& profile, Progress progress) {
  Result<std::string> bytes = writeStep(profile, progress.part(0.0, 0.5));
  if (!bytes) return bytes;
  const Result<StepFileReport> back = inspectStep(*bytes, progress.part(0.5, 1.0));
  if (!back && back.error().code != ErrorCode::LibraryFailed) return back.error();
  if (!back) return notAsMeant("it cannot be opened");
  if (back->solids != 1 || !back->isValid) return notAsMeant("it contains no valid solid");
  if (!(std::abs(back->volume / volumeOf(profile) - 1.0) < tolerance::kWrittenVolume))
    return notAsMeant("its volume differs");
  return bytes;
}

Result<WrittenFile> exportStep(const WorkpieceSnapshot& workpiece, const std::filesystem::path& path,
                               Progress progress) {
  const std::size_t pieces = workpiece.part ? workpiece.part->profile.pieces() : 1;
  if (pieces > 1) return Error{WorkpieceError::SeveralPieces, {std::to_string(pieces)}, {}, path.string()};
  const Result<ProfileCurve> profile = profileOf(workpiece);
  const Result<std::string> bytes =
      profile ? checkedStep(*profile, progress.part(0.0, 0.9)) : Result<std::string>(profile.error());
  if (!bytes) {
    Error error = bytes.error();
    error.subject = path.string();
    return error;
  }
  const Status written = writeFileAtomically(path, *bytes, progress.part(0.9, 1.0));
  if (!written) return written.error();
  return WrittenFile{bytes->size(), {{QT_TRANSLATE_NOOP("Note", "The file contains one valid solid.")}}};
}

Result<TriangleSoup> placedTriangles(const WorkpieceSnapshot& workpiece, Progress progress) {
  if (!workpiece.part) {
    TriangleSoup soup = *workpiece.mesh->soup();
    for (Vec3& p : soup.points) p.z() += workpiece.stock.position;
    return soup;
  }
  const Result<ProfileCurve> profile = profileOf(workpiece);
  if (!profile) return profile.error();
  TessellationOptions options;
  options.chord = 0.5 * workpiece.chord;  // the other half went to the polyline
  return tessellate(*profile, options, progress);
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
  return all;
}

bool WorkpieceKind::recognises(std::string_view, std::string_view) const {
  return false;
}

Result<OpenedFile> WorkpieceKind::import(const std::filesystem::path&, const ReadOptions&, Progress) const {
  return Error{DocumentError::FormatUnknown, {}, {}, {}};
}

Result<WrittenFile> WorkpieceKind::exportTo(const Snapshot& content, const std::filesystem::path& path,
                                            Progress progress) const {
  const WorkpieceSnapshot& workpiece = workpieceOf(content);
  if (isStepName(path)) return exportStep(workpiece, path, progress);
  Result<TriangleSoup> soup = placedTriangles(workpiece, progress.part(0.0, 0.15));
  if (!soup) return soup.error();
  const HalfEdgeMesh mesh = buildMesh(*soup, progress.part(0.15, 0.3)).mesh;
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  const Result<ExportReport> report = exportMesh(mesh, NumberType::Float64, path, progress.part(0.3, 1.0));
  if (!report) return report.error();
  return WrittenFile{report->bytes, notesOn(*report)};
}

void WorkpieceKind::save(const Snapshot& content, Container& container) const {
  nlohmann::json& document = (*container.manifest)["document"];
  if (!document.is_object()) document = nlohmann::json::object();
  for (WorkpieceField field : kWorkpieceFields) {
    const Property property = propertyOf(workpieceOf(content), field);
    std::visit([&](const auto& value) { document[property.id] = value; }, property.value);
  }
  writeTurnedPart(workpieceOf(content), container);
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
    PropertyValue value = false;  // of no field
    if (entry.is_number()) value = entry.get<double>();
    if (entry.is_string()) value = entry.get<std::string>();
    const Status checked = checkValue(field, value);
    if (checked) {
      workpiece = withValue(std::move(workpiece), field, value);
    } else {
      damage.push_back(checked.error());
    }
  }
  auto part = readTurnedPart(*found, workpiece, container, damage, progress);
  if (!part) return part.error();
  workpiece.part = std::move(part.value());
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
  if (workpiece.part) {
    const TurnedPart& part = *workpiece.part;
    described["volume"] = part.profile.volume();
    described["area"] = part.profile.area();
    described["passes"] = part.passes.size();
    described["spacing"] = part.profile.spacing();
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
  if (workpiece.part) return displayOf(workpiece.part->surface, workpiece.stock.position);
  DisplayPart part;
  part.name = "stock";
  part.group = kStockGroup;
  part.soup = workpiece.mesh->soup();
  part.pose.translation().z() = workpiece.stock.position;
  return {{std::move(part)}};
}

GeometryPointer WorkpieceKind::bodyGeometry(const Snapshot& content, std::vector<Note>& notes) const {
  const WorkpieceSnapshot& workpiece = workpieceOf(content);
  const Result<ProfileCurve> profile = profileOf(workpiece);
  if (!profile) return DocumentKind::bodyGeometry(content, notes);
  // Of the tolerance of a part the polyline has had its half.
  const double chord =
      workpiece.part ? std::max(0.5 * workpiece.chord, RevolvedGeometry::kLeastChord) : workpiece.chord;
  auto made = RevolvedGeometry::make(*profile, chord);
  return made ? GeometryPointer(std::move(made).value()) : DocumentKind::bodyGeometry(content, notes);
}

}  // namespace handwheel
