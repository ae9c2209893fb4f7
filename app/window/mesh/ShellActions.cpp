// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/ShellActions.h"

#include "document/mesh/MeshKind.h"
#include "mesh/structure/Shells.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "theme/Icons.h"
#include "tools/mesh/MeshScript.h"
#include "window/ActionToolTip.h"
#include "window/CommandLines.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileFilters.h"
#include "window/mesh/MeshReading.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/MeshUi.h"
#include "window/mesh/repair/RepairJobs.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

namespace handwheel {

namespace {

constexpr std::size_t kMostFilesOfShells = 20;  // opened as tabs; more are for the command line

// "scan.stl" falls into "scan-shells" beside it.
QString shellsFolder(const QString& path) {
  const QFileInfo file(path);
  return file.dir().filePath(file.completeBaseName() + QStringLiteral("-shells"));
}

}  // namespace

ShellActions::ShellActions(const WindowContext& parts, MeshKind& kind, MeshUi& ui, RepairJobs& jobs)
    : QObject(&ui),
      m_parts(parts),
      m_kind(kind),
      m_ui(ui),
      m_jobs(jobs),
      m_split(icon(QStringLiteral("split")), tr("Split into s&hells"), this),
      m_add(icon(QStringLiteral("add-mesh")), tr("&Add a mesh…"), this) {
  m_split.setObjectName(QStringLiteral("splitShells"));
  m_add.setObjectName(QStringLiteral("addMesh"));
  setActionToolTip(m_split, tr("Open each shell (triangles connected across edges) as a separate document"));
  setActionToolTip(m_add, tr("Add the mesh of another file to this one, at its own position"));
  connect(&m_split, &QAction::triggered, this, &ShellActions::split);
  connect(&m_add, &QAction::triggered, this, &ShellActions::askForMesh);
  setDocument(nullptr);
}

void ShellActions::setDocument(MeshTab* document) {
  m_document = document;
  for (QAction* action : all()) action->setEnabled(document != nullptr);
}

void ShellActions::split() {
  Job job;
  job.name = m_split.iconText();
  job.document = &m_document->document;
  job.outlivesDocument = true;
  const bool isAsInFile = m_document->isAsInFile() && !m_document->document.isModified();
  const QString path = m_document->document.path();
  const QString command = isAsInFile ? splitCommand(path, shellsFolder(path)) : QString();
  job.work = [this, document = m_document, command, mesh = m_document->document.mesh(),
              numbers = m_document->document.fileNumbers()](Progress progress) -> Job::Finish {
    const auto shells = findShells(mesh, progress.part(0.0, 0.2));
    std::vector<std::shared_ptr<MeshSnapshot>> contents;
    for (std::size_t i = 0; i < shells.size() && shells.size() <= kMostFilesOfShells && shells.size() > 1; ++i) {
      const double from = 0.2 + 0.8 * double(i) / double(shells.size()), each = 0.8 / double(shells.size());
      MeshFile file;
      file.soup = extracted(mesh, shells[i]).compact().soup;
      file.numbers = numbers;
      contents.push_back(meshSnapshotOf(file, tolerance::kNearWeld, progress.part(from, from + each)));
    }
    return [this, document, command, contents = std::move(contents), count = shells.size()] {
      contents.empty() ? reportCount(document, count) : open(contents, command);
    };
  };
  job.failed = [this, document = m_document](const Error& error) {
    reportFailed(document, tr("The shells could not be opened"), error);
  };
  m_parts.jobs.start(std::move(job));
}

void ShellActions::open(const std::vector<std::shared_ptr<MeshSnapshot>>& shells, const QString& command) {
  for (const auto& shell : shells) {
    OpenedFile opened = DocumentKinds::blank(m_kind);
    opened.content = shell;
    m_parts.tabs.add(m_ui.open(m_kind.make(std::move(opened))));
  }
  m_parts.log.add(tr("Split into %Ln shell(s)", nullptr, static_cast<int>(shells.size())), command);
}

void ShellActions::reportCount(const MeshTab* document, std::size_t shells) {
  if (!m_parts.tabs.contains(document)) return;
  const bool isOne = shells < 2;
  emit message(
      {Message::Weight::Info,
       isOne ? tr("The mesh is one shell") : tr("There are %Ln shell(s)", nullptr, static_cast<int>(shells)),
       {},
       isOne ? QString() : tr("“handwheel split” writes that many into a folder. Debris can be removed first."),
       {},
       {},
       {},
       {},
       &document->document});
}

void ShellActions::reportFailed(const MeshTab* document, const QString& title, const Error& error) {
  if (error.code == ErrorCode::Cancelled || !m_parts.tabs.contains(document)) return;
  emit message(
      {Message::Weight::Error, title, errorSentence(error), errorAdvice(error), {}, {}, {}, {}, &document->document});
}

void ShellActions::askForMesh() {
  auto* dialog = openingDialog(m_parts.window, m_document->document, tr("Add a mesh"),
                               openFilters(m_parts.kinds).join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("addMeshDialog"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (m_parts.tabs.contains(document)) add(document, path);
  });
  dialog->open();
}

void ShellActions::add(MeshTab* document, const QString& path) {
  Job job;
  job.name = tr("Reading %1").arg(QFileInfo(path).fileName());
  job.document = &document->document;
  const QString title = tr("%1 could not be added").arg(QFileInfo(path).fileName());
  job.failed = [this, document, title](const Error& error) { reportFailed(document, title, error); };
  job.work = [this, document, path, title](Progress progress) -> Job::Finish {
    const Result<HalfEdgeMesh> other = readMesh(m_parts.kinds, path, progress);
    if (!other) {
      return [this, document, title, error = other.error()] { reportFailed(document, title, error); };
    }
    return [this, document, path, other = *other] {
      if (!m_parts.tabs.contains(document)) return;
      m_jobs.change(document, addChange(QFile::encodeName(QFileInfo(path).absoluteFilePath()).toStdString(), other));
    };
  };
  m_parts.jobs.start(std::move(job));
}

}  // namespace handwheel
