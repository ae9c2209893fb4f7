// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cell/CellFile.h"

#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "document/cell/CellArms.h"
#include "document/cell/CellImport.h"
#include "text/NoteText.h"

namespace handwheel {

std::optional<OpenedFile> shippedRobot(const std::string& name, const DocumentKinds& kinds) {
  std::error_code ignored;
  const DhTable* const table = std::filesystem::exists(name, ignored) ? nullptr : libraryTable(name);
  if (!table) return std::nullopt;
  OpenedFile file;
  file.kind = kinds.withId("cell");
  file.content = cellOf(*table);
  return file;
}

Result<CellFile> openCell(const std::string& name, const DocumentKinds& kinds) {
  std::optional<Result<OpenedFile>> opened;
  if (auto shipped = shippedRobot(name, kinds))
    opened = *std::move(shipped);
  else
    runInterruptible("Reading", [&](CommandJob& job) { opened = kinds.open(name, {}, job.progress()); });
  if (!*opened) return opened->error();
  reportLosses(opened->value().file);
  auto cell = std::dynamic_pointer_cast<const RobotCellSnapshot>(opened->value().content);
  if (!cell) return Error{ErrorCode::Unsupported, {"a document that is no robot cell"}, {}, name};
  return CellFile{std::move(opened->value()), std::move(cell)};
}

OptionSpec armOption() {
  return {"arm", 0, "NAME", "Robot of a cell with several (default: the one to plan for)"};
}

Result<CellFile> openCellForArm(const Arguments& arguments, const DocumentKinds& kinds, const std::string& path) {
  Result<CellFile> file = openCell(arguments.operands[0], kinds);
  if (!file) return file;
  const RobotPath* const known = file->cell->plans->path(path);
  const std::string arm = arguments.has("arm") ? arguments.valueOf("arm") : known ? known->arm : file->cell->plans->arm;
  Result<CellPlans> plans = withArmChosen(*file->cell->robot, *file->cell->plans, arm);
  if (!plans) return plans.error();
  if (*plans == *file->cell->plans) return file;
  auto cell = std::make_shared<RobotCellSnapshot>(*file->cell);
  file->ownArm = activeArm(*cell->robot, *cell->plans).name;
  cell->plans = std::make_shared<const CellPlans>(std::move(plans).value());
  file->cell = std::move(cell);
  return file;
}

int saveCell(const CellFile& file, const RobotCellSnapshot& given, const std::filesystem::path& output) {
  RobotCellSnapshot content = given;
  if (file.ownArm) {
    const Result<CellPlans> plans = withArmChosen(*content.robot, *content.plans, *file.ownArm);
    if (plans) content.plans = std::make_shared<const CellPlans>(*plans);
  }
  if (const std::string refusal = refusalToReplace(output, file.opened.file); !refusal.empty()) return refuse(refusal);
  std::optional<Result<WrittenFile>> written;
  runInterruptible("Writing", [&](CommandJob& job) {
    written = saveDocument(*file.opened.kind, file.opened.file, content, output, job.progress());
  });
  if (!*written) return fail(written->error());
  for (const Note& note : written->value().notes) complain(noteText(note).toStdString());
  return kExitDone;
}

}  // namespace handwheel
