// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceKind.h"

#include "base/Tolerance.h"
#include "document/AtomicFile.h"
#include "document/formats/MeshExport.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "mesh/structure/MeshBuilder.h"
#include "nurbs/CylinderDistance.h"
#include "nurbs/StepFile.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr std::string_view kStepStart = "ISO-10303-21";  // ISO 10303-21, 5.1

const WorkpieceSnapshot& workpieceOf(const Snapshot& content) {
  return static_cast<const WorkpieceSnapshot&>(content);
}

bool isStepName(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return ending == ".step" || ending == ".stp";
}

Error notAsMeant(const char* what) {
  return {ErrorCode::CheckFailed, {what}, {}, {}};
}

// The bytes, after another look at what they hold.
Result<std::string> checkedStep(const StockCylinder& stock, Progress progress) {
  Result<std::string> bytes = writeStep(stock.profile(), progress.part(0.0, 0.5));
  if (!bytes) return bytes;
  const Result<StepReport> back = inspectStep(*bytes, progress.part(0.5, 1.0));
  if (!back && back.error().code != ErrorCode::LibraryFailed) return back.error();
  if (!back) return notAsMeant("it cannot be opened");
  if (back->solids != 1 || !back->isValid) return notAsMeant("it holds no valid solid");
  if (!(std::abs(back->volume / stock.volume() - 1.0) < tolerance::kWrittenVolume))
    return notAsMeant("its volume differs");
  return bytes;
}

Result<WrittenFile> exportStep(const StockCylinder& stock, const std::filesystem::path& path, Progress progress) {
  const Result<std::string> bytes = checkedStep(stock, progress.part(0.0, 0.9));
  if (!bytes) {
    Error error = bytes.error();
    error.subject = path.string();
    return error;
  }
  const Status written = writeFileAtomically(path, *bytes, progress.part(0.9, 1.0));
  if (!written) return written.error();
  return WrittenFile{bytes->size(), {{QT_TRANSLATE_NOOP("Note", "The file holds one valid solid.")}}};
}

TriangleSoup placedTriangles(const WorkpieceSnapshot& workpiece) {
  TriangleSoup soup = *workpiece.mesh->soup();
  for (Vec3& p : soup.points) p.z() += workpiece.stock.position;
  return soup;
}

}  // namespace

std::string WorkpieceKind::title() const {
  return QT_TRANSLATE_NOOP("DocumentKind", "Workpiece");
}

std::vector<FileFormat> WorkpieceKind::formats() const {
  std::vector<FileFormat> all{{"STEP", {".step", ".stp"}, false, true}};
  for (FileFormat& format : meshFileFormats()) {
    format.reads = false;
    all.push_back(std::move(format));
  }
  return all;
}

bool WorkpieceKind::recognises(std::string_view head, std::string_view) const {
  return head.starts_with(kStepStart);
}

Result<OpenedFile> WorkpieceKind::import(const std::filesystem::path&, const ReadOptions&, Progress) const {
  return Error{ErrorCode::Unsupported, {"reading STEP files"}, {}, {}};
}

Result<WrittenFile> WorkpieceKind::exportTo(const Snapshot& content, const std::filesystem::path& path,
                                            Progress progress) const {
  const WorkpieceSnapshot& workpiece = workpieceOf(content);
  if (isStepName(path)) return exportStep(workpiece.stock, path, progress);
  const HalfEdgeMesh mesh = buildMesh(placedTriangles(workpiece), progress.part(0.0, 0.3)).mesh;
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
}

Result<SnapshotPointer> WorkpieceKind::load(const Container& container, std::vector<Error>& damage, Progress) const {
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
  StockCylinder atOrigin = workpiece.stock;
  atOrigin.position = 0.0;
  const TriangleSoup& soup = *workpiece.mesh->soup();
  return {{"diameter", workpiece.stock.diameter},
          {"length", workpiece.stock.length},
          {"position", workpiece.stock.position},
          {"material", workpiece.material},
          {"volume", workpiece.stock.volume()},
          {"area", workpiece.stock.area()},
          {"chord", workpiece.chord},
          {"triangles", soup.triangles.size()},
          {"deviation", distanceToCylinder(soup, atOrigin)}};
}

DisplayModel WorkpieceKind::display(const Snapshot& content) const {
  const WorkpieceSnapshot& workpiece = workpieceOf(content);
  DisplayPart part;
  part.name = "stock";
  part.soup = workpiece.mesh->soup();
  part.pose.translation().z() = workpiece.stock.position;
  return {{std::move(part)}};
}

}  // namespace handwheel
