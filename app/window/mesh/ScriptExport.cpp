// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/ScriptExport.h"

#include "document/AtomicFile.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "window/ActionToolTip.h"
#include "window/CommandLines.h"
#include "window/OfferedAction.h"
#include "window/documents/DocumentTabs.h"
#include "window/mesh/EquivalentCommand.h"
#include "window/mesh/MeshTab.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>

namespace handwheel {

ScriptExport::ScriptExport(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_save(tr("Save s&teps…"), this) {
  m_save.setObjectName(QStringLiteral("saveSteps"));
  setActionToolTip(m_save, tr("Write what was done to the mesh as a file that “handwheel edit --steps” reads"));
  connect(&m_save, &QAction::triggered, this, &ScriptExport::ask);
  follow();
}

void ScriptExport::setDocument(MeshTab* document) {
  m_document = document;
  follow();
}

void ScriptExport::follow() {
  offer(m_save, m_document && presentPoint(m_document->document) != HistoryPoint(),
        m_document ? tr("Nothing was changed.") : tr("Open a mesh first."));
}

void ScriptExport::ask() {
  auto* dialog = new QFileDialog(m_parts.window, tr("Save steps"), stepsName(m_document->document.path()),
                                 tr("Steps (%1)").arg(QStringLiteral("*.steps")));
  dialog->setObjectName(QStringLiteral("saveStepsDialog"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  dialog->setDefaultSuffix(QStringLiteral("steps"));
  connect(dialog, &QFileDialog::fileSelected, this, [this, document = m_document](const QString& path) {
    if (m_parts.tabs.contains(document)) write(*document, path);
  });
  dialog->open();
}

void ScriptExport::write(const MeshTab& document, const QString& path) {
  const QString name = QFileInfo(path).fileName();
  const auto sequence = editPath(document);
  if (!sequence) {
    emit message({Message::Weight::Warning,
                  tr("%1 was not written").arg(name),
                  tr("There is no file from which the steps reproduce the current state."),
                  tr("Save the document as *.handwheel, and continue from there."),
                  {},
                  {},
                  {},
                  {},
                  &document.document});
    return;
  }
  const Status written = writeFileAtomically(QFile::encodeName(path).toStdString(), stepsText(*sequence).toStdString());
  if (!written) {
    emit message({Message::Weight::Error,
                  tr("%1 could not be saved").arg(name),
                  errorSentence(written.error()),
                  errorAdvice(written.error()),
                  {},
                  {},
                  {},
                  {},
                  &document.document});
    return;
  }
  m_parts.log.add(tr("Saved the steps as %1").arg(name),
                  editCommandLine(sequence->base->path, path, editedName(document.document.path())));
}

}  // namespace handwheel
