// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/fidelity/BenchmarkRunner.h"

#include "fidelity/MeasuredSettings.h"
#include "text/ErrorText.h"
#include "window/fidelity/FidelityChoice.h"

#include <QApplication>
#include <QEvent>

namespace handwheel {

namespace {

bool isInput(QEvent::Type type) {
  switch (type) {
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::TabletMove:
    case QEvent::TabletPress:
    case QEvent::TouchBegin:
    case QEvent::TouchUpdate:
    case QEvent::NativeGesture:
    case QEvent::DragMove:
      return true;
    default:
      return false;
  }
}

}  // namespace

BenchmarkRunner::BenchmarkRunner(FidelityChoice& choice, QThreadPool& pool, const std::filesystem::path& file,
                                 QObject* parent)
    : QObject(parent), m_choice(choice), m_file(file), m_runner(JobRunner::Policy::Queue, pool) {
  m_idle.setSingleShot(true);
  connect(&m_idle, &QTimer::timeout, this, &BenchmarkRunner::beginIdle);
  connect(&m_runner, &JobRunner::progressed, this, [this] {
    if (m_isByItself && m_isBusy && m_isBusy()) return cancel();
    m_part = m_runner.jobs().front().fraction;
    emit progressed();
  });
  load(file);
}

void BenchmarkRunner::load(const std::filesystem::path& file) {
  const Result<Calibration> kept = loadCalibration(m_choice.registry(), file);
  if (!kept) {
    if (kept.error().code == ErrorCode::FileMissing) return;  // never measured
    const bool isDamaged = kept.error().code == ErrorCode::ElementMalformed;
    m_problem = tr("The measurements of this machine cannot be used: %1")
                    .arg(isDamaged ? tr("the file is damaged.") : errorSentence(kept.error()));
  } else if (kept->machine != machineClass()) {
    m_problem = tr("The stored measurements are from another machine (%1).").arg(QString::fromStdString(kept->machine));
  } else {
    m_choice.setCalibration(*kept);
  }
}

void BenchmarkRunner::start() {
  if (m_isRunning) return;
  m_isByItself = false;
  begin(machineDependent(m_choice.registry()));
}

void BenchmarkRunner::begin(std::vector<const FidelityRegistry::Entry*> entries) {
  if (entries.empty()) return;
  m_entries = std::move(entries);
  m_done = 0;
  m_isRunning = true;
  m_before = m_choice.isFit() ? std::optional(m_choice.values()) : std::nullopt;
  m_problem.clear();
  m_elapsed.start();
  next();
}

// The worker stores the measurements setting by setting: a write to the disk may take its time.
void BenchmarkRunner::next() {
  if (m_done == m_entries.size() || m_elapsed.elapsed() > std::chrono::milliseconds(kLongestCalibration).count())
    return end();
  m_part = 0.0;
  Job job;
  job.name = present();
  // With cases of its own: a run that was cancelled may still be at work on others.
  job.work = [this, id = m_entries[m_done]->setting.id, file = m_file,
              all = m_choice.calibration()](Progress progress) mutable -> Job::Finish {
    const FidelityRegistry registry = measuredSettings();
    if (!calibrate(*registry.find(id), all, progress)) return {};  // cancelled
    const Status stored = storeCalibration(registry, all, file);
    return [this, all, stored] { measured(all, stored); };
  };
  job.failed = [this](const Error& error) {
    if (error.code == ErrorCode::Cancelled) return;
    m_problem = errorSentence(error);
    end();
  };
  m_runner.start(std::move(job));
  emit changed();
}

void BenchmarkRunner::measured(const Calibration& calibration, const Status& stored) {
  m_choice.setCalibration(calibration);
  if (!stored) m_problem = tr("The measurements could not be saved: %1").arg(errorSentence(stored.error()));
  ++m_done;
  next();
}

// If the user has chosen Fit, the values that fit by the new curves are applied.
void BenchmarkRunner::end() {
  m_isRunning = false;
  if (m_before == m_choice.values() && !m_choice.isFit()) m_choice.use(m_choice.fit().values);
  emit changed();
}

void BenchmarkRunner::cancel() {
  if (!m_isRunning) return;
  m_runner.cancelAll();
  end();
  if (m_isByItself && m_isBusy) m_idle.start();
}

double BenchmarkRunner::fraction() const {
  return m_entries.empty() ? 0.0 : (static_cast<double>(m_done) + m_part) / static_cast<double>(m_entries.size());
}

QString BenchmarkRunner::present() const {
  if (!m_isRunning || m_done == m_entries.size()) return {};
  return QCoreApplication::translate("Fidelity", m_entries[m_done]->setting.label.c_str());
}

std::vector<const FidelityRegistry::Entry*> BenchmarkRunner::missing() const {
  auto entries = machineDependent(m_choice.registry());
  std::erase_if(entries, [this](const auto* e) { return m_choice.calibration().curves.contains(e->setting.id); });
  return entries;
}

void BenchmarkRunner::beginWhenIdle(std::function<bool()> isBusy, int idleMs) {
  if (missing().empty()) return;
  m_isBusy = std::move(isBusy);
  m_idle.setInterval(idleMs);
  m_idle.start();
  qApp->installEventFilter(this);
}

void BenchmarkRunner::beginIdle() {
  if (m_isRunning || m_isBusy()) return m_idle.start();
  const auto entries = missing();
  if (entries.empty()) {  // nothing to wait for any more
    qApp->removeEventFilter(this);
    m_isBusy = nullptr;
    return;
  }
  m_isByItself = true;
  begin(entries);
}

bool BenchmarkRunner::eventFilter(QObject* watched, QEvent* event) {
  if (isInput(event->type())) {
    if (m_isRunning && m_isByItself) cancel();
    if (!m_isRunning && m_isBusy) m_idle.start();
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace handwheel
