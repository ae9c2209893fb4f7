// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/HolePreview.h"

#include "mesh/measure/MeshFidelity.h"
#include "window/WindowServices.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/mesh/MeshTab.h"

#include <QElapsedTimer>
#include <utility>

namespace handwheel {

namespace {

bool isSame(const EarWeights& a, const EarWeights& b) {
  return a.length == b.length && a.angles == b.angles && a.normal == b.normal && a.lid == b.lid;
}

// Tries each method by itself: if a method fails, no other replaces it. shown: the patch of the preview, if any; it may
// be of a method that succeeds only after others have failed.
std::vector<MethodTrial> tryMethods(const HoleFiller& filler, const BoundaryLoop& loop, FillOptions options,
                                    const std::optional<FillAttempt>& shown, Progress progress) {
  std::vector<MethodTrial> trials;
  options.tryOthers = false;
  for (const FillMethod method : HoleSettings::methods()) {
    if (progress.cancelled()) break;
    options.method = method;
    QElapsedTimer clock;
    clock.start();
    FillAttempt attempt = filler.propose(loop, options, progress);
    if (attempt.failure != FillFailure::None && shown && shown->patch.method == method) attempt = *shown;
    MethodTrial trial{method, attempt.failure, {}, 1e-6 * static_cast<double>(clock.nsecsElapsed())};
    if (attempt.failure == FillFailure::None) trial.statistics = statisticsOf(filler.mesh(), loop, attempt.patch);
    trials.push_back(trial);
  }
  return trials;
}

}  // namespace

HolePreview::HolePreview(QThreadPool& pool, WindowServices& services, const FidelityChoice& fidelity, QObject* parent)
    : QObject(parent),
      m_services(services),
      m_fidelity(fidelity),
      m_runner(JobRunner::Policy::Latest, pool, this),
      m_choice(std::make_shared<OperationValues>(fillOperation())) {
  connect(&fidelity, &FidelityChoice::changed, this, &HolePreview::followFidelity);
  followFidelity();
}

void HolePreview::setDocument(MeshTab* document) {
  forget();
  m_shown = document;
  m_choice = document ? document->fillChoice : nullptr;
  if (!m_choice) m_choice = std::make_shared<OperationValues>(fillOperation());
  if (document) document->fillChoice = m_choice;
  followFidelity();
  emit changed();
}

void HolePreview::followFidelity() {
  FidelityValues values = m_fidelity.values();
  if (m_shown) {
    for (const FidelitySetting& setting : {fillMethodSetting(), fillContinuitySetting()}) {
      const FidelityValues& chosen = m_shown->document.fillChoice();
      if (chosen.overrides().contains(setting.id)) (void)values.set(setting, chosen.of(setting));
    }
  }
  FillOptions options;
  apply(values, options);
  m_choice->setValid("fill", static_cast<double>(options.method));
  m_choice->setValid("continuity", static_cast<double>(options.continuity));
}

void HolePreview::noteChoice() {
  if (!m_shown) return;
  const FillOptions chosen = fillOptionsOf(*m_choice);
  FillOptions usual;
  apply(m_fidelity.values(), usual);
  FidelityValues choice;
  if (chosen.method != usual.method) setMethod(choice, chosen.method);
  if (chosen.continuity != usual.continuity)
    (void)choice.set(fillContinuitySetting(), static_cast<double>(chosen.continuity));
  if (choice != m_shown->document.fillChoice()) m_shown->document.setFillChoice(std::move(choice));
}

FillOptions HolePreview::optionsFor(Vertex key) const {
  FillOptions options;
  apply(m_fidelity.values(), options);
  const FillOptions chosen = fillOptionsOf(*m_choice);
  options.method = chosen.method;
  options.continuity = chosen.continuity;
  options.ears = chosen.ears;
  if (key != kNone && key == m_bridgedLoop) options.bridges = m_bridges;
  return options;
}

void HolePreview::request(MeshTab* document, int loop) {
  noteChoice();
  if (!document || loop < 0) document = nullptr;
  const std::uint64_t revision = document ? document->document.revision() : 0;
  const Vertex key = document ? document->defectList.keyOf(loop) : kNone;
  const FillOptions options = optionsFor(key);
  const bool sameHole = document == m_document && revision == m_revision && key == m_key &&
                        options.density == m_options.density && options.continuity == m_options.continuity &&
                        options.bridges == m_options.bridges && isSame(options.ears, m_options.ears);
  if (!sameHole) m_trials.clear();
  const bool same = sameHole && options.method == m_options.method;
  if (same && (!document || m_state.kind != PreviewState::Kind::Off)) return;
  if (document && (document != m_fillerCacheDocument || revision != m_fillerCacheRevision)) m_fillerCache = nullptr;
  m_document = document;
  m_revision = revision;
  m_key = key;
  m_loop = loop;
  m_options = options;
  start();
}

void HolePreview::setUserBridges(Vertex key, std::vector<HoleBridge> bridges) {
  m_bridgedLoop = key;
  m_bridges = std::move(bridges);
  if (m_document && m_key == key) refresh();
}

void HolePreview::start() {
  ++m_request;
  m_attempt.reset();
  m_state = {};
  m_need = m_document ? m_services.needs().need("fill_preview") : ServiceHandle();
  if (!m_document) {
    m_runner.cancelAll();
    emit changed();
    return;
  }
  if (!m_fillerCache) returnCache(m_document, std::make_shared<HoleFillerCache>(m_document->document.mesh()));
  m_state.kind = PreviewState::Kind::Working;
  emit changed();
  const MeshDocument& document = m_document->document;
  m_options.numbers = document.fileNumbers();
  Job job;
  job.name = tr("Preview");
  job.work = [this, &service = m_services.fillPreview(), cache = m_fillerCache,
              loop = m_document->defectList.loop(m_loop), options = m_options,
              request = m_request](Progress progress) -> Job::Finish {
    const ServiceTick tick(service);
    HoleFiller* filler = cache->filler(progress.part(0.0, 0.5));
    if (!filler) return {};
    auto attempt = std::make_shared<FillAttempt>(filler->propose(loop, options, progress.part(0.5, 1.0)));
    const PatchComparison shape = attempt->failure == FillFailure::None
                                      ? handwheel::compared(filler->mesh(), loop, attempt->patch)
                                      : PatchComparison();
    return [this, attempt, shape, request] { finished(request, std::move(*attempt), shape); };
  };
  m_runner.start(std::move(job));
}

void HolePreview::finished(std::uint64_t request, FillAttempt attempt, const PatchComparison& shape) {
  if (request != m_request) return;
  m_state.kind = attempt.failure == FillFailure::None ? PreviewState::Kind::Ready : PreviewState::Kind::Failed;
  m_state.triangles = attempt.patch.triangles.size();
  m_state.method = attempt.patch.method;
  m_state.substitute = substituteIn(attempt.patch, m_options);
  m_state.failure = attempt.failure;
  m_state.shape = shape;
  m_attempt = std::move(attempt);
  emit changed();
}

void HolePreview::compare() {
  const bool isReady = m_state.kind == PreviewState::Kind::Ready || m_state.kind == PreviewState::Kind::Failed;
  if (!isReady || !m_trials.empty() || !m_fillerCache) return;
  Job job;
  job.name = tr("Comparing methods");
  job.work = [this, &service = m_services.fillPreview(), cache = m_fillerCache,
              loop = m_document->defectList.loop(m_loop), options = m_options,
              shown = m_state.kind == PreviewState::Kind::Ready ? m_attempt : std::nullopt,
              request = m_request](Progress progress) -> Job::Finish {
    const ServiceTick tick(service);
    HoleFiller* filler = cache->filler(progress.part(0.0, 0.1));
    if (!filler) return {};
    auto trials =
        std::make_shared<std::vector<MethodTrial>>(tryMethods(*filler, loop, options, shown, progress.part(0.1, 1.0)));
    return [this, trials, request] {
      if (request != m_request) return;
      m_trials = std::move(*trials);
      emit compared();
    };
  };
  m_runner.start(std::move(job));
}

const FillAttempt* HolePreview::attempt() const {
  return m_attempt ? &*m_attempt : nullptr;
}

// A worker that still compares methods needs the filler: one thread at a time.
PreparedFill HolePreview::take(Vertex key) {
  PreparedFill prepared{nullptr, std::nullopt, optionsFor(key)};
  if (m_state.kind == PreviewState::Kind::Ready || m_state.kind == PreviewState::Kind::Failed) {
    prepared = {m_runner.isIdle() ? m_fillerCache : nullptr, std::move(m_attempt), m_options};
  }
  m_fillerCache = nullptr;
  clear();
  return prepared;
}

void HolePreview::forget() {
  m_fillerCache = nullptr;
  clear();
}

void HolePreview::returnCache(MeshTab* document, std::shared_ptr<HoleFillerCache> cache) {
  m_fillerCache = std::move(cache);
  m_fillerCacheDocument = document;
  m_fillerCacheRevision = document->document.revision();
}

}  // namespace handwheel
