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

// Measures the time cost of the settings on this machine. The settings are measured one after another on a worker
// thread, and the results are stored in a file. A run starts on request, or automatically while the user is idle and a
// setting has never been measured. A key or the mouse stops a run that started automatically; earlier measurements are
// kept. Must be used on the window thread.
class BenchmarkRunner : public QObject {
  Q_OBJECT

 public:
  // file: the file that stores the curves. Its contents are loaded.
  BenchmarkRunner(FidelityChoice& choice, QThreadPool& pool, const std::filesystem::path& file,
                  QObject* parent = nullptr);

  // Measures all settings anew. Takes about half a minute, one minute at most. Does nothing while a run is in progress.
  void start();
  // Stops the run at once; the pending result of the worker is discarded.
  void cancel();
  bool isRunning() const { return m_isRunning; }
  double fraction() const;  // progress of all measurements, 0…1
  // Returns the name of the setting being measured, translated.
  QString present() const;
  // The reason why the stored results could not be loaded or the new ones could not be stored, as a sentence; empty: no
  // problem.
  const QString& problem() const { return m_problem; }

  // Makes a run start automatically after idleMs without a key or the mouse, unless the window is busy.
  void beginWhenIdle(std::function<bool()> isBusy, int idleMs = 30'000);
  bool isWaiting() const { return m_isBusy != nullptr; }  // returns true if a run may start when the user is idle

 signals:
  void changed();     // a run started, ended, or moved on to another setting
  void progressed();  // the progress within one setting changed

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
  double m_part = 0.0;  // progress of the present setting, 0…1
  QString m_problem;
  QElapsedTimer m_elapsed;
  QTimer m_idle;
  std::function<bool()> m_isBusy;  // null: no run starts automatically
  bool m_isRunning = false;
  bool m_isByItself = false;
  std::optional<FidelityValues> m_before;  // values of the preset Fit, if it was chosen at the start
};

}  // namespace handwheel
