// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/ReshapeActions.h"

#include "document/volume/VolumeDocument.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "volume/SurfaceToVolume.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileDialogs.h"
#include "window/documents/FileFilters.h"
#include "window/tools/ToolHost.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

namespace handwheel {
namespace {

// The material of a document, as a volume of this grid where it is made of a surface.
Result<SparseVolume> materialOf(const DocumentKind& kind, const Snapshot& content, const SparseVolume& grid,
                                Progress progress) {
  if (const auto* const volume = dynamic_cast<const VolumeSnapshot*>(&content)) return volume->volume;
  Result<SurfaceVolume> made =
      volumeOfSurface(placedSoup(kind.display(content)), grid.voxel(), progress, grid.origin());
  if (!made) return made.error();
  return std::move(made->volume);
}

}  // namespace

ReshapeActions::ReshapeActions(const WindowContext& parts, QObject* parent) : QObject(parent), m_parts(parts) {
  using Change = ReshapeTool::Change;
  const auto add = [this](Change change, const QString& text, const char* name, const char* iconName,
                          const QString& tip) {
    QAction& action = m_actions[static_cast<std::size_t>(change)];
    action.setParent(this);  // so that commands and keys find it
    action.setText(text);
    prepare(action, name, iconName, tip);
    action.setEnabled(false);
    connect(&action, &QAction::triggered, this, [this, change] { start(change); });
  };
  add(Change::Shell, tr("Make s&hell…"), "volumeShell", nullptr, tr("Leave a wall along the surface"));
  add(Change::Offset, tr("Move s&urface…"), "volumeOffset", nullptr, tr("Move the surface out or in"));
  add(Change::Boolean, tr("C&ombine…"), "volumeBoolean", nullptr,
      tr("Unite with another document or file, subtract it, or keep what both have"));
  add(Change::Debris, tr("Remove &debris…"), "volumeDebris", "debris", tr("Take small parts away"));
  add(Change::Gaps, tr("Close &gaps…"), "volumeGaps", nullptr, tr("Fill gaps, cracks and pits"));
  add(Change::Smooth, tr("Smooth &all…"), "volumeSmooth", nullptr, tr("Take small bumps and dents off"));
}

QList<QAction*> ReshapeActions::all() {
  QList<QAction*> actions;
  for (QAction& action : m_actions) actions << &action;
  return actions;
}

void ReshapeActions::setDocument(DocumentTab* document, const QString& reason) {
  if (document != m_document) m_files.clear();
  m_document = document;
  for (QAction& action : m_actions) offer(action, document && reason.isEmpty(), reason);
}

void ReshapeActions::start(ReshapeTool::Change change) {
  m_change = change;
  if (dynamic_cast<const ReshapeTool*>(m_parts.tools.runner().tool()))
    return m_parts.tools.runner().setSetting("change", static_cast<double>(change));
  m_parts.chooseTool(QStringLiteral("reshapeTool"));
}

// A job of a tool that is gone has nothing to do.
void ReshapeActions::followTool() {
  if (!dynamic_cast<const ReshapeTool*>(m_parts.tools.runner().tool())) m_parts.jobs.cancelOf(this);
}

ToolDescriptor ReshapeActions::tool() {
  const auto make = [this]() -> std::unique_ptr<Tool> {
    return std::make_unique<ReshapeTool>(static_cast<VolumeDocument&>(m_document->document), services(), m_change);
  };
  return {QStringLiteral("reshapeTool"),
          tr("Change &whole volume"),
          tr("Shell, moved surface, combination with another body, debris, gaps, smoothing"),
          QStringLiteral("kind-volume"),
          QKeySequence(Qt::SHIFT | Qt::Key_H),
          make,
          "reshape",
          ReshapeTool::keys()};
}

ReshapeServices ReshapeActions::services() {
  ReshapeServices services;
  services.run = [this](ReshapeServices::Job wanted, std::function<void()> stopped) {
    m_parts.jobs.cancelOf(this);
    Job job;
    job.name = QCoreApplication::translate("Tool", wanted.name);
    job.document = &m_document->document;
    job.owner = this;
    job.lane = Job::Lane::Looking;
    job.work = [this, work = std::move(wanted.work)](Progress progress) -> Job::Finish {
      return [this, finish = work(progress)] { m_parts.tools.runner().deliver(finish); };
    };
    job.failed = [this, stopped, name = job.name](const Error& error) {
      m_parts.tools.runner().deliver(stopped);
      if (error.code != ErrorCode::Cancelled)
        emit message({Message::Weight::Error, name, errorSentence(error), errorAdvice(error)});
    };
    m_parts.jobs.start(std::move(job));
  };
  services.cancel = [this] { m_parts.jobs.cancelOf(this); };
  services.bodies = [this] { return bodies(); };
  services.addFile = [this] { addFile(); };
  services.failed = [this](const Error& error) {
    Message notice{Message::Weight::Warning, tr("The volume cannot be changed like that"), errorSentence(error),
                   errorAdvice(error)};
    notice.about = m_document ? &m_document->document : nullptr;
    emit message(notice);
  };
  return services;
}

std::vector<OtherBody> ReshapeActions::bodies() const {
  std::vector<OtherBody> all;
  for (const auto& tab : m_parts.tabs.all()) {
    const DocumentKind& kind = tab->document.kind();
    const bool isSolid = kind.id() == "volume" || kind.id() == "mesh" || kind.id() == "workpiece";
    if (tab.get() == m_document || !isSolid) continue;
    // Copies of a file share the id of their document.
    const DocumentFile& file = tab->document.file();
    all.push_back({file.id + '\n' + file.path, tab->document.name().toStdString(),
                   [&kind, content = tab->document.snapshot()](const SparseVolume& grid, Progress progress) {
                     return materialOf(kind, *content, grid, progress);
                   }});
  }
  for (const QString& path : m_files)
    all.push_back({path.toStdString(), QFileInfo(path).fileName().toStdString(),
                   [&kinds = m_parts.kinds, path = std::filesystem::path(QFile::encodeName(path).toStdString())](
                       const SparseVolume& grid, Progress progress) -> Result<SparseVolume> {
                     const Result<OpenedFile> opened = kinds.open(path, {}, progress.part(0.0, 0.4));
                     if (!opened) return opened.error();
                     return materialOf(*opened->kind, *opened->content, grid, progress.part(0.4, 1.0));
                   }});
  return all;
}

void ReshapeActions::addFile() {
  auto* const dialog = openingDialog(m_parts.window, m_document->document, tr("Combine with"),
                                     openFilters(m_parts.kinds).join(QStringLiteral(";;")));
  dialog->setObjectName(QStringLiteral("combineDialog"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (document != m_document) return;
    if (!m_files.contains(path)) m_files << path;
    m_parts.tools.runner().setSetting("with", path.toStdString());
  });
  dialog->open();
}

}  // namespace handwheel
