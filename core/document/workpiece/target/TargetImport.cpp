// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/TargetImport.h"

#include "base/NumberText.h"
#include "base/Utf8.h"
#include "document/Container.h"
#include "document/DocumentErrors.h"
#include "document/FileBytes.h"
#include "document/formats/MeshFormatTable.h"
#include "document/formats/step/StepReader.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/refit/SampledProfile.h"
#include "machining/section/SectionOutline.h"
#include "machining/target/ProfileFromMesh.h"
#include "machining/target/files/DxfReader.h"
#include "machining/target/files/SvgReader.h"

#include <QtGlobal>
#include <algorithm>

namespace handwheel {

namespace {

Note noUnit() {
  return {QT_TRANSLATE_NOOP("Note", "The file does not say its unit of length: taken as 1 mm in DXF, a pixel in SVG.")};
}

Result<ImportedTarget> fromDrawing(const Result<Drawing>& drawing, Progress progress) {
  if (!drawing) return drawing.error();
  Result<TargetProfile> target = targetIn(*drawing, progress);
  if (!target) return target.error();
  ImportedTarget imported{std::move(target.value()), {}, {}};
  if (!drawing->hasUnit) imported.notes.push_back(noUnit());
  std::string others;
  for (const auto& [name, count] : drawing->others)
    others += (others.empty() ? "" : ", ") + std::to_string(count) + " " + (isUtf8(name) ? name : std::string("?"));
  if (!others.empty())
    imported.notes.push_back({QT_TRANSLATE_NOOP("Note", "Not read from the drawing: %1."), {others}});
  return imported;
}

Result<ImportedTarget> fromStep(std::string_view bytes, UnturnedFaces others, Progress progress) {
  Result<ProfileFromStep> read = readProfileFromStep(bytes, others, progress);
  if (!read) return read.error();
  ImportedTarget imported{std::move(read->target), {}, {}};
  if (read->ignoredFaces > 0)
    imported.notes.push_back({QT_TRANSLATE_NOOP("Note", "Faces that are not of revolution were ignored: %1."),
                              {std::to_string(read->ignoredFaces)}});
  return imported;
}

Result<ImportedTarget> fromWorkpiece(std::string_view bytes, Progress progress) {
  std::vector<std::unique_ptr<DocumentKind>> own;
  own.push_back(std::make_unique<WorkpieceKind>());
  const DocumentKinds kinds(std::move(own));
  const Result<OpenedFile> opened = kinds.openContainer(bytes, progress);
  if (!opened) return opened.error();
  const auto& workpiece = static_cast<const WorkpieceSnapshot&>(*opened->content);
  if (workpiece.target) return ImportedTarget{workpiece.target->profile, {}, {}, true};
  Result<TargetProfile> section = sectionOf(workpiece);
  if (!section) return section.error();
  return ImportedTarget{std::move(section.value()), {}, sectionNotes(workpiece), true};
}

// 3MF is an archive, as our own.
bool isMesh(std::string_view head, const std::string& name) {
  return formatForName(name) && !looksLikeContainer(head);
}

Result<ImportedTarget> fromMesh(std::string_view bytes, const std::string& name, Progress progress) {
  const Result<MeshFile> mesh = readMesh(bytes, name, {}, progress.part(0.0, 0.5));
  if (!mesh) return mesh.error();
  Result<ProfileFromMesh> turned = profileFromMesh(mesh->soup, progress.part(0.5, 1.0));
  if (!turned) return turned.error();
  ImportedTarget imported{std::move(turned->target), {}, {}};
  imported.notes.push_back({QT_TRANSLATE_NOOP("Note", "The rings of the mesh leave their circles by up to %1 mm."),
                            {roundedText(turned->deviation, 3)}});
  return imported;
}

Result<ImportedTarget> importAny(std::string_view bytes, const std::string& name, UnturnedFaces others,
                                 Progress progress) {
  const std::string_view head = bytes.substr(0, kFileHead);
  const Progress reading = progress.part(0.0, 0.6), joining = progress.part(0.6, 1.0);
  if (looksLikeStep(head)) return fromStep(bytes, others, progress);
  const bool hasMesh = isMesh(head, name);
  if (bytes.starts_with("PK") && !hasMesh) return fromWorkpiece(bytes, progress);
  if (looksLikeSvg(head)) return fromDrawing(readSvg(bytes, reading), joining);
  if (looksLikeDxf(head)) return fromDrawing(readDxf(bytes, reading), joining);
  if (hasMesh) return fromMesh(bytes, name, progress);
  return Error{DocumentError::FormatUnknown, targetEndings(), {}, {}};
}

}  // namespace

Result<ImportedTarget> importTarget(const std::filesystem::path& path, UnturnedFaces others, Progress progress) {
  const Result<std::string> bytes = readFileBytes(path, progress.part(0.0, 0.1));
  Result<ImportedTarget> imported = bytes ? importAny(*bytes, path.filename().string(), others, progress.part(0.1, 1.0))
                                          : Result<ImportedTarget>(bytes.error());
  if (!imported) {
    Error error = imported.error();
    error.subject = path.string();
    return error;
  }
  imported->source = path.filename().string();
  if (!isUtf8(imported->source)) imported->source.clear();
  return imported;
}

std::vector<std::string> targetEndings() {
  std::vector<std::string> endings;
  for (const MeshFormatRow& row : meshFormatTable().rows())  // STEP among them
    endings.insert(endings.end(), row.endings.begin(), row.endings.end());
  endings.insert(endings.end(), {".dxf", ".svg", std::string(kContainerEnding)});
  return endings;
}

std::shared_ptr<const WorkpieceTarget> placedTarget(const ImportedTarget& imported, const StockCylinder& stock,
                                                    std::optional<double> allowance) {
  constexpr double kSlack = 1e-3;  // mm
  const TargetProfile& profile = imported.profile;
  const double lower = stock.position - kSlack, upper = stock.position + stock.length + kSlack;
  const bool stays = imported.isPlaced && !allowance && profile.lowerEnd() >= lower && profile.upperEnd() <= upper;
  return std::make_shared<const WorkpieceTarget>(WorkpieceTarget{
      stays ? profile : withAllowance(profile, stock, allowance.value_or(usualAllowance(profile, stock))),
      imported.source});
}

Result<TargetProfile> sectionOf(const WorkpieceSnapshot& workpiece) {
  const StockCylinder& stock = workpiece.stock;
  if (!workpiece.part) {
    const double r = 0.5 * stock.diameter;
    return TargetProfile::make({{{r, stock.position}, {r, stock.position + stock.length}, 0.0}});
  }
  const std::vector<TurnedSection> pieces = workpiece.part->section().pieces();
  if (pieces.empty()) return Error{ErrorCode::ElementMalformed, {"profile", "nothing is left of the part"}, {}, {}};
  return outlineOf(pieces.back(), 0.5 * workpiece.chord, stock.position);
}

std::vector<Note> sectionNotes(const WorkpieceSnapshot& workpiece) {
  if (!workpiece.part || workpiece.part->section().pieces().size() < 2) return {};
  return {Note{QT_TRANSLATE_NOOP("Note", "The part is parted off: only the piece at its free end counts."), {}, true}};
}

}  // namespace handwheel
