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

// Measures the settings whose cost is time on this machine, one after another on a worker, and keeps what it found in a
// file: when the user asks, or by itself while nobody does anything, where there is something that was never measured.
// A key or the mouse stops what began by itself; what was measured by then stays. Window thread.
class Calibrator : public QObject {
  Q_OBJECT

 public:
  // file: where curves are kept. What was kept there holds from now on.
  Calibrator(FidelityChoice& choice, QThreadPool& pool, const std::filesystem::path& file, QObject* parent = nullptr);

  // All of them anew, for about half a minute and at most one. Does nothing while it runs.
  void start();
  // At once: what the worker still does is thrown away.
  void cancel();
  bool isRunning() const { return m_isRunning; }
  double fraction() const;  // 0…1, of all
  // What is measured now, translated.
  QString present() const;
  // Why what was kept before is not used, or was not kept now; a sentence, or empty.
  const QString& problem() const { return m_problem; }

  // From now on it begins by itself after so long without a key or the mouse, unless the window is busy.
  void beginWhenIdle(std::function<bool()> isBusy, int idleMs = 30'000);
  bool isWaiting() const { return m_isBusy != nullptr; }  // for that

 signals:
  void changed();     // begun, ended, or another setting
  void progressed();  // within one

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
  std::vector<const FidelityRegistry::Entry*> m_entries;  // of this run
  std::size_t m_done = 0;
  double m_part = 0.0;  // of the present one
  QString m_problem;
  QElapsedTimer m_elapsed;
  QTimer m_idle;
  std::function<bool()> m_isBusy;  // null: it does not begin by itself
  bool m_isRunning = false;
  bool m_isByItself = false;
  std::optional<FidelityValues> m_before;  // those of Fit, when they were chosen as it began
};

}  // namespace handwheel
