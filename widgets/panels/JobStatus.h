// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace handwheel {

// The displayed state of a job.
struct JobStatus {
  quint64 id = 0;
  QString name;
  double fraction = -1.0;  // finished fraction, 0…1; below zero: unknown
  bool isWaiting = false;  // the job waits for earlier jobs
  int seconds = 0;         // working time so far, s
  QString document = {};   // name of the document of the job; empty: it has none
};

}  // namespace handwheel
