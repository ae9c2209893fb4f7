// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/SelfIntersectionSearch.h"

#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "window/WindowServices.h"
#include "window/mesh/MeshTab.h"

#include <utility>

namespace handwheel {

namespace {
// Long enough for the model to be on the screen first, and for a quick series of edits to be searched once.
constexpr int kRestMs = 500;
}  // namespace

SelfIntersectionSearch::SelfIntersectionSearch(QThreadPool& pool, WindowServices& services, QObject* parent)
    : QObject(parent), m_services(services), m_runner(JobRunner::Policy::Latest, pool, this) {
  m_rest.setSingleShot(true);
  m_rest.setInterval(kRestMs);
  connect(&m_rest, &QTimer::timeout, this, &SelfIntersectionSearch::start);
}

void SelfIntersectionSearch::setDocument(MeshTab* document) {
  if (m_document) m_document->defectList.disconnect(this);
  m_document = document;
  m_rest.stop();
  m_runner.cancelAll();
  m_need = document ? m_services.needs().need("self_intersections") : ServiceHandle();
  if (!document) return;
  connect(&document->defectList, &DefectList::changed, this, &SelfIntersectionSearch::schedule);
  schedule();
}

void SelfIntersectionSearch::schedule() {
  if (m_document->defectList.selfIntersections()) return;
  m_rest.start();
}

void SelfIntersectionSearch::start() {
  if (!m_document || m_document->defectList.selfIntersections()) return;
  Job job;
  job.name = tr("Searching self-intersections");
  job.work = [this, &service = m_services.selfIntersections(), document = m_document,
              revision = m_document->document.revision(), numbers = m_document->document.fileNumbers(),
              mesh = m_document->document.mesh()](Progress progress) -> Job::Finish {
    const ServiceTick tick(service);
    FacePairs found = selfIntersectingPairs(mesh, numbers, progress);
    if (progress.cancelled()) return {};
    return [this, document, revision, numbers, pairs = std::move(found)]() mutable {
      if (document == m_document && document->document.fileNumbers() == numbers)
        document->defectList.setSelfIntersections(revision, std::move(pairs));
    };
  };
  m_runner.start(std::move(job));
}

}  // namespace handwheel
