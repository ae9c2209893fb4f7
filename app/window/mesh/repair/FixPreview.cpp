// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/repair/FixPreview.h"

#include "window/WindowServices.h"
#include "window/mesh/MeshTab.h"

#include <QCoreApplication>
#include <QLocale>
#include <tuple>

namespace handwheel {

FixPreview::FixPreview(QThreadPool& pool, WindowServices& services, const QAction& isWanted, QObject* parent)
    : QObject(parent), m_services(services), m_isWanted(isWanted), m_runner(JobRunner::Policy::Latest, pool, this) {
  connect(&m_isWanted, &QAction::toggled, this, &FixPreview::start);
}

void FixPreview::request(MeshTab* document, std::optional<OfferedFix> fix) {
  if (!document || !fix) document = nullptr, fix.reset();
  const std::uint64_t revision = document ? document->document.revision() : 0;
  const auto nameOf = [](const OfferedFix& of) { return std::tuple(of.action, of.kind, of.row); };
  const bool isSame = fix && m_fix ? nameOf(*fix) == nameOf(*m_fix) : !fix && !m_fix;
  if (document == m_document && revision == m_revision && isSame) return;
  m_document = document;
  m_revision = revision;
  m_fix = std::move(fix);
  start();
}

void FixPreview::start() {
  ++m_request;
  m_shown = {};
  m_isReady = false;
  std::optional<MeshChange> fix = m_fix && m_isWanted.isChecked() ? m_fix->make() : std::nullopt;
  m_isWorking = fix.has_value();
  m_need = m_isWorking ? m_services.needs().need("fill_preview") : ServiceHandle();
  if (!m_isWorking) {
    m_runner.cancelAll();
    emit changed();
    return;
  }
  emit changed();
  Job job;
  job.name = tr("Preview");
  job.work = [this, &service = m_services.fillPreview(), fix = std::move(*fix), mesh = m_document->document.mesh(),
              request = m_request](Progress progress) -> Job::Finish {
    const ServiceTick tick(service);
    const auto preview = std::make_shared<ChangePreview>(previewOf(fix, mesh, progress));
    return [this, preview, request] {
      if (request != m_request) return;
      m_isWorking = false;
      m_isReady = true;
      m_shown = std::move(*preview);
      emit changed();
    };
  };
  job.failed = [this, request = m_request](const Error&) {
    if (request != m_request) return;
    m_isWorking = false;
    emit changed();
  };
  m_runner.start(std::move(job));
}

QString FixPreview::text() const {
  if (m_isWorking) return tr("Computing the preview…");
  if (!m_isReady) return {};
  if (m_shown.isEmpty())
    return m_shown.reason ? tr("Nothing would change: %1.").arg(QCoreApplication::translate("Tool", m_shown.reason))
                          : tr("Nothing would change.");
  const int removed = static_cast<int>(m_shown.removed.count());
  const int added = static_cast<int>(m_shown.added.triangles.size());
  if (added == 0) return tr("Removes %Ln triangle(s).", nullptr, removed);
  if (removed == 0) return tr("Adds %Ln triangle(s).", nullptr, added);
  return tr("Replaces %1 by %2.").arg(tr("%Ln triangle(s)", nullptr, removed), QLocale().toString(added));
}

}  // namespace handwheel
