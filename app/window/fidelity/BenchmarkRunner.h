// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/Calibration.h"
#include "window/JobRunner.h"

#include <QElapsedTimer>
#include <functional>
#include <optional>

namespace handwheel {

class FidelityChoice;

// Measures the time cost of the settings on this machine. Works through the settings on a worker thread and stores the
// results in a file. Runs on request, or by itself while the user is idle and there is a setting that was never
// measured. A key or the mouse stops a run that started by itself; earlier measurements are kept. Window thread.
class BenchmarkRunner : public QObject {
  Q_OBJECT

 public:
  // file: stores the curves. Its contents are loaded.
  BenchmarkRunner(FidelityChoice& choice, QThreadPool& pool, const std::filesystem::path& file,
                  QObject* parent = nullptr);

  // Measures all settings anew. Takes about half a minute, one minute at most. Does nothing while it runs.
  void start();
  // Stops at once; the pending result of the worker is discarded.
  void cancel();
  bool isRunning() const { return m_isRunning; }
  double fraction() const;  // 0…1, progress of all measurements
  // Returns the name of the setting being measured, translated.
  QString present() const;
  // The reason why the stored results could not be loaded, or the new ones not stored; a sentence, or empty.
  const QString& problem() const { return m_problem; }

  // Makes it start by itself after idleMs without a key or the mouse, unless the window is busy.
  void beginWhenIdle(std::function<bool()> isBusy, int idleMs = 30'000);
  bool isWaiting() const { return m_isBusy != nullptr; }  // waits for idle time

 signals:
  void changed();     // the run started, ended, or went on to another setting
  void progressed();  // progress within one setting

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void load(const std::filesystem::path& file);
  void begin(std::vector<const FidelityRegistry::Entry*> entries);
  void beginIdle();
  void next();
  void measured(const Calibration& calibration, const Status& stored);
  void end();
  std::vector<const FidelityRegistry::Entry*> missing() const;

  FidelityChoice& m_choice;
  std::filesystem::path m_file;
  JobRunner m_runner;
  std::vector<const FidelityRegistry::Entry*> m_entries;  // settings of this run
  std::size_t m_done = 0;
  double m_part = 0.0;  // fraction of the present setting
  QString m_problem;
  QElapsedTimer m_elapsed;
  QTimer m_idle;
  std::function<bool()> m_isBusy;  // null: it does not start by itself
  bool m_isRunning = false;
  bool m_isByItself = false;
  std::optional<FidelityValues> m_before;  // values of the preset Fit, if it was chosen at the start
};

}  // namespace handwheel
