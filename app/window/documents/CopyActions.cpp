// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/CopyActions.h"

#include "document/Document.h"
#include "panels/MessageBar.h"
#include "text/ErrorText.h"
#include "theme/Icons.h"
#include "window/ActionToolTip.h"
#include "window/JobRunner.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace handwheel {

CopyActions::CopyActions(QWidget* window, const DocumentKinds& kinds, const KindUis& uis, DocumentTabs& tabs,
                         JobRunner& jobs, Open open)
    : QObject(window), m_uis(uis), m_tabs(tabs), m_jobs(jobs), m_open(std::move(open)) {
  for (const auto& kind : kinds.all()) {
    if (!kind->isMadeOfSurfaces()) continue;
    const QString title = QCoreApplication::translate("DocumentKind", kind->title().c_str());
    auto* action = new QAction(tr("Open a copy as %1").arg(title), this);
    action->setObjectName(QStringLiteral("copyAs/") + QString::fromStdString(kind->id()));
    action->setIcon(icon(QStringLiteral("kind-") + QString::fromStdString(kind->id())));
    setActionToolTip(*action, tr("Open the surface of this document as a new document of that kind"));
    connect(action, &QAction::triggered, this, [this, made = kind.get()] { ask(*made); });
    m_actions.emplace_back(kind.get(), action);
  }
  connect(&m_tabs, &DocumentTabs::currentChanged, this, &CopyActions::follow);
  follow();
}

QList<QAction*> CopyActions::actions() const {
  QList<QAction*> all;
  for (const auto& [kind, action] : m_actions) all << action;
  return all;
}

void CopyActions::follow() {
  const DocumentTab* const current = m_tabs.current();
  for (const auto& [kind, action] : m_actions) action->setEnabled(current && &current->document.kind() != kind);
}

void CopyActions::ask(const DocumentKind& kind) {
  DocumentTab* const from = m_tabs.current();
  from->document.settle();
  const auto begin = [this, &kind, from](const MakeOfSurface& make) {
    if (m_tabs.contains(from)) start(kind, from, make);
  };
  if (m_uis.at(kind.id())->askToCopy(from->document, begin)) return;
  start(kind, from, [&kind](const TriangleSoup& surface, const std::string& source, std::vector<Note>&, Progress p) {
    return kind.ofSurface(surface, source, p);
  });
}

void CopyActions::start(const DocumentKind& kind, DocumentTab* from, const MakeOfSurface& make) {
  Job job;
  const QString name = from->document.name();
  job.name = tr("Copying %1").arg(name);
  const auto failed = [this, name](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return;
    emit message({Message::Weight::Error, tr("%1 was not copied").arg(name), errorSentence(error), errorAdvice(error)});
  };
  // It is called as the other one, without the ending.
  const std::string& known = from->document.file().title;
  const bool isTitled = from->document.path().isEmpty() || !known.empty();
  const std::string title = isTitled ? known : QFileInfo(name).completeBaseName().toStdString();
  job.work = [this, failed, make, &kind, title, source = from->document.sharedName().toStdString(),
              isPrivate = from->document.file().hasPrivateName, &own = from->document.kind(),
              content = from->document.snapshot(), file = from->document.file().path,
              unit = from->document.displayUnit()](Progress progress) -> Job::Finish {
    OpenedFile opened;
    Result<SnapshotPointer> made = make(placedSoup(own.display(*content)), source, opened.file.notes, progress);
    if (!made) return [failed, error = made.error()] { failed(error); };
    opened.kind = &kind;
    opened.file.id = newDocumentId();
    opened.file.title = title;
    opened.file.hasPrivateName = isPrivate;
    opened.file.displayUnit = unit;
    opened.file.copyOf = file;
    opened.content = std::move(*made);
    return [this, opened = std::move(opened)]() mutable { m_open(std::move(opened)); };
  };
  job.failed = failed;
  job.document = &from->document;
  job.lane = Job::Lane::Looking;
  job.outlivesDocument = true;
  m_jobs.start(std::move(job));
}

}  // namespace handwheel
