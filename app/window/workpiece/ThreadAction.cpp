// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/ThreadAction.h"

#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/exercise/AssignedTask.h"
#include "machining/TurningFidelity.h"
#include "panels/MessageBar.h"
#include "window/ActionToolTip.h"
#include "window/OfferedAction.h"
#include "window/documents/DiscardedResult.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/workpiece/ThreadDialog.h"

namespace handwheel {

ThreadAction::ThreadAction(const WindowContext& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_cut(tr("T&hread…"), this) {
  m_cut.setObjectName(QStringLiteral("thread"));
  setActionToolTip(m_cut, tr("Cut a thread outside or in a bore, between two heights"));
  connect(&m_cut, &QAction::triggered, this, &ThreadAction::ask);
}

void ThreadAction::setDocument(DocumentTab* document) {
  m_document = document;
  const auto task = document ? assignedTask(document->document.file().assigned) : nullptr;
  offer(m_cut, document && (!task || task->areCommandsAllowed),
        document ? tr("The exercise does not allow it: cut the thread on the lathe, by its half-nut.")
                 : tr("Open a workpiece first."));
}

void ThreadAction::ask() {
  const auto& owner = static_cast<const WorkpieceDocument&>(m_document->document);
  auto* dialog = new ThreadDialog(owner.workpiece(), owner.displayUnit(), m_parts.window);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ThreadDialog::chosen, this, [this, document = m_document](const TurningPass& pass) {
    if (m_parts.tabs.contains(document)) cut(document, pass);
  });
  dialog->open();
}

// If the part was cut in the meantime, the thread is not cut, and the user is told so.
void ThreadAction::cut(DocumentTab* document, const TurningPass& pass) {
  const auto& owner = static_cast<const WorkpieceDocument&>(document->document);
  Job job;
  job.name = tr("Cutting the thread");
  job.document = &document->document;
  job.work = [this, document, pass, name = job.name, value = owner.workpiece(),
              spacing = m_parts.fidelity.values().of(turnSpacingSetting())](Progress progress) -> Job::Finish {
    auto part = withPass(value, pass, spacing, progress);
    return [this, document, name, value, part] {
      if (!part || !m_parts.tabs.contains(document)) return;
      auto& now = static_cast<WorkpieceDocument&>(document->document);
      const WorkpieceSnapshot& work = now.workpiece();
      const bool isSame = work.part == value.part && work.stock == value.stock && work.chord == value.chord;
      if (!isSame) return emit message(discardedResultMessage(name, now));
      now.commit(tr("Thread"), std::make_unique<TurnedPartEdit>(part));
    };
  };
  m_parts.jobs.start(std::move(job));
}

}  // namespace handwheel
