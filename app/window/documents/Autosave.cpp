// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/Autosave.h"

#include "document/DocumentKind.h"
#include "panels/LogModel.h"
#include "text/ErrorText.h"
#include "tools/UnfinishedGesture.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/documents/FileLoader.h"
#include "window/tools/ToolHost.h"

#include <QFile>
#include <algorithm>
#include <utility>

namespace handwheel {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

// Edits within that time are saved together.
constexpr milliseconds kSoon{250};
// The pause after an autosave, in the time that it took: a twentieth of the time is spent on it.
constexpr int kPause = 19;
// Sessions in use at the start are checked again after the first pause, then after twice that, up to the last pause:
// for a minute in all. A program that was killed keeps its lock until the system has freed its memory, or written its
// core.
constexpr milliseconds kFirstLook{250}, kLastLook{32'000};

}  // namespace

Autosave::Autosave(DocumentTabs& tabs, FileLoader& loader, LogModel& log, WindowServices& services, QObject* parent)
    : QObject(parent),
      m_tabs(tabs),
      m_loader(loader),
      m_log(log),
      m_services(services),
      m_jobs(JobRunner::Policy::Queue, m_pool),
      m_session(std::make_shared<RecoverySession>()) {
  m_pool.setMaxThreadCount(1);
  m_timer.setSingleShot(true);
  connect(&m_timer, &QTimer::timeout, this, &Autosave::saveWork);
  connect(&m_tabs, &DocumentTabs::added, this, &Autosave::follow);
  connect(&m_tabs, &DocumentTabs::closing, this, [this](DocumentTab* document) {
    document->document.disconnect(this);
    m_session->close(m_followed[document].key);
    m_followed.erase(document);
    rest();
  });
}

void Autosave::setInterval(int seconds) {
  m_timer.setInterval(1000 * seconds);
}

void Autosave::follow(DocumentTab* document) {
  Followed& followed = m_followed[document];
  followed.key = ++m_lastKey;
  followed.timer = std::make_unique<QTimer>();
  followed.timer->setSingleShot(true);
  connect(followed.timer.get(), &QTimer::timeout, this, [this, document] { saveChanged(document); });
  document->autosaved = document->document.revision();
  connect(&document->document, &Document::changed, this, [this, document] { changed(document); });
  connect(&document->document, &Document::fileChanged, this, [this, document] {
    if (!document->document.isModified()) return m_session->remove(m_followed[document].key);
    if (document->autosaved != document->document.revision()) changed(document);
  });
}

// Until the edit is in the history, it is unknown if the document differs from its file.
void Autosave::changed(DocumentTab* document) {
  if (m_timer.interval() == 0) return;
  need();
  const Followed& followed = m_followed[document];
  if (!followed.timer->isActive()) followed.timer->start(pauseAfter(followed.cost));
}

milliseconds Autosave::pauseAfter(milliseconds cost) const {
  return std::min(std::max(kSoon, kPause * cost), m_timer.intervalAsDuration());
}

void Autosave::need() {
  if (!m_need.isNeeded()) m_need = m_services.needs().need("autosave");
}

void Autosave::rest() {
  const auto waits = [](const auto& each) { return each.second.timer->isActive(); };
  if (!m_timer.isActive() && std::none_of(m_followed.begin(), m_followed.end(), waits)) m_need = ServiceHandle();
}

void Autosave::watch(ToolHost& tools) {
  m_tools = &tools;
  connect(&tools, &ToolHost::updated, this, [this] {
    if (m_timer.interval() == 0 || m_timer.isActive() || !hasWorkGoingOn()) return;
    need();
    m_timer.start();
  });
}

// Returns true if a tool runs whose gestures take minutes, and changes something now.
bool Autosave::hasWorkGoingOn() const {
  const Tool* const tool = m_tools->runner().tool();
  return dynamic_cast<const UnfinishedGesture*>(tool) && tool->isLive();
}

void Autosave::saveChanged(DocumentTab* document) {
  if (document->document.isModified() && document->autosaved != document->document.revision()) {
    const SnapshotPointer value = m_tools ? m_tools->valueWithGesture(document->document) : nullptr;
    save(document, value ? value : document->document.snapshot());
  }
  rest();
}

void Autosave::saveWork() {
  for (const auto& each : m_tabs.all()) {
    if (const SnapshotPointer value = m_tools->valueWithGesture(each->document)) save(each.get(), value);
  }
  if (hasWorkGoingOn()) m_timer.start();  // saves the unfinished work
  rest();
}

void Autosave::save(DocumentTab* document, SnapshotPointer content) {
  const std::uint64_t revision = document->document.revision(), key = m_followed[document].key;
  AutosaveInfo info;
  info.documentId = document->document.file().id;
  info.path = document->document.file().path;
  info.name = document->document.name().toStdString();
  info.kind = document->document.kind().id();
  info.stamp = document->document.file().stamp;
  info.hasPrivateName = document->document.file().hasPrivateName;
  info.isPartial = document->document.file().wouldLoseDataOnOverwrite();
  document->autosaved = revision;
  const auto failed = [this, document, key, name = document->document.name()](const Error& error) {
    if (isFollowed(document, key)) reportFailure(document, name, error);
  };
  Job job;
  job.name = tr("Autosaving %1").arg(document->document.name());
  job.failed = failed;
  job.work = [this, document, failed, key, info, session = m_session, &service = m_services.autosave(),
              &kind = document->document.kind(), file = document->document.file(),
              content = std::move(content)](Progress progress) -> Job::Finish {
    const ServiceTick tick(service);
    const Clock::time_point start = Clock::now();
    const Result<Container> container = containerOf(kind, file, *content, info.path, progress.part(0.0, 0.2));
    const Status stored =
        container ? session->store(key, info, *container, progress.part(0.2, 1.0)) : Status(container.error());
    const auto cost = std::chrono::duration_cast<milliseconds>(Clock::now() - start);
    if (stored) {
      return [this, document, key, cost] {
        if (isFollowed(document, key)) noteCost(document, cost);
      };
    }
    return [failed, error = stored.error()] { failed(error); };
  };
  m_jobs.start(std::move(job));
}

// Another document may have the address of one that is closed, but no other key is the same.
bool Autosave::isFollowed(const DocumentTab* document, std::uint64_t key) const {
  const auto followed = m_followed.find(document);
  return followed != m_followed.end() && followed->second.key == key;
}

void Autosave::noteCost(DocumentTab* document, milliseconds cost) {
  Followed& followed = m_followed[document];
  followed.cost = cost;
  followed.isFailing = false;
}

// It is tried again within the interval; only the first of several failures is reported.
void Autosave::reportFailure(DocumentTab* document, const QString& name, const Error& error) {
  document->autosaved = 0;
  Followed& followed = m_followed[document];
  need();
  followed.timer->start(m_timer.intervalAsDuration());
  if (std::exchange(followed.isFailing, true)) return;
  const QString title = tr("%1 could not be autosaved").arg(name);
  m_log.add(title + QStringLiteral(". ") + errorSentence(error), {}, LogEntry::Weight::Warning);
  emit message({Message::Weight::Warning,
                title,
                errorSentence(error),
                tr("Save it now: if the program ended unexpectedly, your last changes would be lost."),
                {},
                {},
                {},
                {},
                &document->document});
}

void Autosave::offerRecovery() {
  offer(OrphanedAutosaves());
}

// The messages keep the orphans, and so their locks, until they are answered or closed.
void Autosave::offer(OrphanedAutosaves found) {
  lookAgain(found.inUse(), kFirstLook);
  const auto orphans = std::make_shared<const OrphanedAutosaves>(std::move(found));
  if (!orphans->skipped().empty()) offerDamaged(orphans);
  if (!orphans->found().empty()) offer(orphans);
}

// Running programs, and this one, have no orphaned files.
void Autosave::lookAgain(std::vector<std::filesystem::path> sessions, milliseconds pause) {
  if (sessions.empty() || pause > kLastLook) return;
  QTimer::singleShot(pause, this, [this, sessions = std::move(sessions), pause] {
    OrphanedAutosaves found = OrphanedAutosaves::of(sessions);
    if (found.found().empty() && found.skipped().empty()) return lookAgain(found.inUse(), 2 * pause);
    offer(std::move(found));
  });
}

void Autosave::offer(const std::shared_ptr<const OrphanedAutosaves>& orphans) {
  QStringList names;
  for (const OrphanedAutosave& orphan : orphans->found()) {
    const QString name = QString::fromStdString(orphan.info.name);
    names << (orphan.isOutdated ? tr("%1 (its file was saved since)").arg(name) : name);
  }
  emit message({Message::Weight::Warning,
                tr("Handwheel ended unexpectedly. %Ln document(s) had changes that were not saved.", nullptr,
                   static_cast<int>(names.size())),
                names.join(QStringLiteral(", ")),
                tr("They can be recovered as they were last autosaved, or discarded permanently; otherwise they are "
                   "offered again at the next start."),
                tr("Recover"),
                [this, orphans] { recover(orphans); },
                tr("Discard…"),
                [this, orphans] { askBeforeDiscarding(orphans); },
                nullptr,
                {},
                true});
}

void Autosave::askBeforeDiscarding(const std::shared_ptr<const OrphanedAutosaves>& orphans) {
  emit message({Message::Weight::Warning,
                tr("Discard %Ln document(s) permanently?", nullptr, static_cast<int>(orphans->found().size())),
                tr("Their changes since they were last saved cannot be recovered."),
                {},
                tr("Keep"),
                [this, orphans] { offer(orphans); },
                tr("Discard"),
                [this, orphans] { discard(*orphans); },
                nullptr,
                {},
                true});
}

void Autosave::offerDamaged(const std::shared_ptr<const OrphanedAutosaves>& orphans) {
  for (const Error& error : orphans->skipped()) m_log.add(errorSentence(error), {}, LogEntry::Weight::Warning);
  const auto count = static_cast<int>(orphans->skipped().size());
  emit message({Message::Weight::Warning,
                tr("%Ln autosave(s) of a session that ended unexpectedly cannot be read.", nullptr, count),
                tr("The files are listed in the Log."),
                tr("Their contents are lost. They are kept until you discard them."), tr("Discard"),
                [this, orphans, count] {
                  orphans->discardSkipped();
                  m_log.add(tr("Discarded %Ln autosave(s)", nullptr, count));
                }});
}

void Autosave::recover(const std::shared_ptr<const OrphanedAutosaves>& orphans) {
  for (const OrphanedAutosave& orphan : orphans->found()) {
    m_loader.recover(orphan.file, orphan.info, [this, orphans, &orphan](DocumentTab* recovered) {
      const Status adopted = m_session->adopt(orphan, m_followed[recovered].key);
      if (!adopted) m_log.add(errorSentence(adopted.error()), {}, LogEntry::Weight::Warning);
    });
  }
}

void Autosave::discard(const OrphanedAutosaves& orphans) {
  for (const OrphanedAutosave& orphan : orphans.found()) orphans.discard(orphan);
  m_log.add(tr("Discarded %Ln autosave(s)", nullptr, static_cast<int>(orphans.found().size())));
}

}  // namespace handwheel
