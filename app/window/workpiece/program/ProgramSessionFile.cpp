// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Reading a program and saving it.
#include "controls/program/ProgramEditor.h"
#include "machining/program/ProgramCheck.h"
#include "panels/LogModel.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/FileDialogs.h"
#include "window/kinds/SuggestedName.h"
#include "window/workpiece/program/ProgramSession.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QTextCursor>
#include <utility>

namespace handwheel {

namespace {

const auto kProgramFolderKey = QStringLiteral("program/folder");

}  // namespace

void ProgramSession::askForFile() {
  auto* dialog = new QFileDialog(m_parts.window, tr("Open a program"),
                                 QSettings().value(kProgramFolderKey, folderFor(m_document.document)).toString(),
                                 tr("Programs (%1);;All files (*)").arg(programNameFilter()));
  dialog->setObjectName(QStringLiteral("programDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setFileMode(QFileDialog::ExistingFile);
  connect(dialog, &QFileDialog::fileSelected, this, &ProgramSession::read);
  dialog->open();
}

void ProgramSession::read(const QString& path) {
  Job job;
  job.name = tr("Reading %1").arg(QFileInfo(path).fileName());
  job.failed = [this, path](const Error& error) {
    fail(tr("%1 could not be opened").arg(QFileInfo(path).fileName()), error);
  };
  job.work = [this, path, failed = job.failed](Progress progress) -> Job::Finish {
    const Result<ProgramFile> file = readProgramFile(path.toStdString(), progress);
    if (!file) return [failed, error = file.error()] { failed(error); };
    return [this, path, read = *file] { taken(path, read); };
  };
  m_files.start(std::move(job));
}

void ProgramSession::taken(const QString& path, const ProgramFile& file) {
  QSettings().setValue(kProgramFolderKey, QFileInfo(path).absolutePath());
  if (const auto dialect = recognisedDialect(file.text.toStdString())) {
    m_tools = inDialect(std::move(m_tools), m_panel->dialect(), *dialect);
    m_panel->setDialect(*dialect);
  }
  ++m_texts;
  m_path = path;
  m_file = file;
  setText(file.text, {});
  m_panel->editor().document()->setModified(false);
  showName();
  m_parts.log.add(tr("Program read from %1").arg(QFileInfo(path).fileName()));
}

// Uses the cursor, so that the editor can undo the change.
void ProgramSession::setText(const QString& text, ProgramTools tools) {
  if (!tools.empty()) {
    m_panel->setNose(tools.begin()->second.noseRadius);
    setTools(std::move(tools), false);
  } else if (!m_hasOwnTools) {
    setTools({}, false);
  }
  QTextCursor all(m_panel->editor().document());
  all.select(QTextCursor::Document);
  all.insertText(text);
  m_panel->editor().goTo(1);
}

void ProgramSession::save(std::function<void(bool)> ended) {
  if (m_path.isEmpty()) return askForName(std::move(ended));
  write(m_path, std::move(ended));
}

void ProgramSession::askForName(std::function<void(bool)> ended) {
  auto* dialog = new QFileDialog(m_parts.window, tr("Save the program"),
                                 QSettings().value(kProgramFolderKey, folderFor(m_document.document)).toString(),
                                 tr("Programs (%1);;All files (*)").arg(programNameFilter()));
  dialog->setObjectName(QStringLiteral("saveProgramDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const bool isFanuc = m_panel->dialect() == ProgramDialect::Fanuc;
  const QString ending = isFanuc ? QStringLiteral("nc") : QStringLiteral("ngc");
  dialog->setDefaultSuffix(ending);
  const QFileInfo ofDocument(m_document.ui.suggestedName(m_document));
  dialog->selectFile(m_path.isEmpty() ? fileNameOf({ofDocument.completeBaseName()}, ending) : m_path);
  connect(dialog, &QFileDialog::fileSelected, this, [this, ended](const QString& path) { write(path, ended); });
  if (ended) connect(dialog, &QFileDialog::rejected, this, [ended] { ended(false); });
  dialog->open();
}

void ProgramSession::write(const QString& path, std::function<void(bool)> ended) {
  QSettings().setValue(kProgramFolderKey, QFileInfo(path).absolutePath());
  ProgramFile file = m_file;
  file.text = m_panel->editor().toPlainText();
  const int revision = m_panel->editor().document()->revision();
  // Later: the document may be closed then, and this session with the runner of the job, which is not over yet.
  const auto after = [window = m_parts.window, ended = std::move(ended)](bool isSaved) {
    if (ended)
      QMetaObject::invokeMethod(
          window, [ended, isSaved] { ended(isSaved); }, Qt::QueuedConnection);
  };
  Job job;
  job.name = tr("Saving %1").arg(QFileInfo(path).fileName());
  job.lane = Job::Lane::Saving;
  job.failed = [this, path, after](const Error& error) {
    fail(tr("%1 could not be saved").arg(QFileInfo(path).fileName()), error);
    after(false);
  };
  job.work = [this, path, file, revision, text = m_texts, after,
              failed = job.failed](Progress progress) -> Job::Finish {
    const Status written = writeProgramFile(path.toStdString(), file, progress);
    if (!written) return [failed, error = written.error()] { failed(error); };
    return [this, path, revision, text, after] {
      if (text == m_texts) m_path = path;  // else another program has come meanwhile
      if (m_panel->editor().document()->revision() == revision) m_panel->editor().document()->setModified(false);
      showName();
      m_parts.log.add(tr("Program saved as %1").arg(QFileInfo(path).fileName()));
      after(true);
    };
  };
  m_files.start(std::move(job));
}

}  // namespace handwheel
