// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/EquivalentCommand.h"

#include "document/DocumentKind.h"
#include "tools/mesh/ScriptLine.h"
#include "tools/mesh/operations/RepairOperation.h"
#include "window/CommandLines.h"
#include "window/mesh/MeshTab.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>

namespace handwheel {

namespace {

// A deletion of scattered triangles has millions of characters: such steps are not even put together.
bool isLong(const std::vector<std::string>& steps) {
  std::size_t length = 0;
  for (const std::string& step : steps) length += step.size();
  return length > kLongestCommand;
}

// With a file of the steps where they would be too long: the one that "Save steps" offers for a document of this path.
QString lineOf(const QString& from, const std::vector<std::string>& steps, const QString& to, const QString& path) {
  const QString command = isLong(steps) ? QString() : editCommandLine(from, steps, to);
  const bool isShort = !command.isEmpty() && command.size() <= kLongestCommand;
  return isShort ? command : editCommandLine(from, stepsName(path), to);
}

}  // namespace

QString stepCommand(const MeshTab& document, const std::string& step) {
  if (step.empty()) return {};
  const QString path = document.document.path();
  if (document.isAsInFile() && !document.document.isModified()) {
    // Those that have a command of their own take the same words.
    if (step.starts_with("decimate ")) return ownCommand(path, step, editedName(path));
    return lineOf(path, {step}, editedName(path), path);
  }
  return step.size() > kLongestCommand ? QString() : QStringLiteral("… %1 …").arg(stepWord(step));
}

QString repairCommand(const QString& path, const RepairOptions& options) {
  OperationValues values = valuesOf(options);
  values.reset("numbers");  // those of the file that is written
  const QString command = ownCommand(path, ScriptLineWriter("repair").options(values).text(), repairedName(path));
  if (options.keepOpen.empty()) return command;
  QStringList ids;
  for (int id : options.keepOpen) ids << QString::number(id);
  return command + QStringLiteral(" --keep-open ") + ids.join(QLatin1Char(','));
}

std::optional<OperationSequence> editPath(const MeshTab& document, bool toContainer) {
  for (auto base = document.bases.rbegin(); base != document.bases.rend(); ++base) {
    auto steps = scriptLinesSince(document.document, base->state);
    if (!steps) continue;
    const LengthUnit unit = document.document.displayUnit();
    if (toContainer && unit != base->displayUnit) steps->push_back(std::string("unit ") + symbolOf(unit));
    return OperationSequence{&*base, std::move(*steps)};
  }
  return std::nullopt;
}

QString editCommand(const MeshTab& document, const QString& to) {
  const auto path = editPath(document, isContainerName(QFile::encodeName(to).toStdString()));
  if (!path) return {};
  const QString& from = path->base->path;
  if (path->steps.empty()) return from == to || path->base->isReplaced ? QString() : convertCommand(from, to);
  QString command = lineOf(from, path->steps, to, to);
  if (path->base->isReplaced)
    command += QStringLiteral("  # with %1 as it was when it was opened").arg(QFileInfo(from).fileName());
  return command;
}

QString stepsName(const QString& path) {
  const QFileInfo file(path);
  return file.dir().filePath(file.completeBaseName() + QStringLiteral(".steps"));
}

QByteArray stepsText(const OperationSequence& path) {
  QByteArray text = "# handwheel edit " + QFileInfo(path.base->path).fileName().toUtf8() + " --steps THIS -o OUT\n";
  for (const std::string& step : path.steps) text += QByteArray::fromStdString(step) + '\n';
  return text;
}

void noteFile(MeshTab& open) {
  const MeshDocument& document = open.document;
  const DocumentFile& file = document.file();
  const bool isUntouched = document.history()->count() == document.openingSteps();
  if (!document.isModified() && !document.history()->isClean()) return;  // back to what the file has: nothing is saved
  if (document.isModified()) {
    if (isUntouched) open.bases.clear();  // recovered: nobody knows what its file holds
    return;
  }
  if (file.path.empty() || !file.damage.empty()) return;
  // The command line opens other formats in millimetres.
  const LengthUnit unit = file.isContainer ? document.displayUnit() : LengthUnit::Millimetre;
  const OperationsOrigin now{document.path(), presentPoint(document), unit};
  const auto same = std::find_if(open.bases.begin(), open.bases.end(),
                                 [&now](const OperationsOrigin& base) { return base.path == now.path; });
  const bool isFirst = open.bases.empty() && isUntouched;
  if (same != open.bases.end() && file.isContainer) open.bases.erase(same);
  if (file.isContainer || isFirst) {
    open.bases.push_back(now);
  } else if (same != open.bases.end() && same->state != now.state) {
    same->isReplaced = true;
  }
}

}  // namespace handwheel
