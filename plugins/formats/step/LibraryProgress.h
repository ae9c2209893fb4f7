// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <Message_ProgressIndicator.hxx>
#include <Message_ProgressScope.hxx>

namespace handwheel {

// Forwards the progress of Open CASCADE to a Progress.
class LibraryProgress : public Message_ProgressIndicator {
 public:
  explicit LibraryProgress(Progress progress) : m_progress(progress) {}
  void Show(const Message_ProgressScope&, const Standard_Boolean) override { m_progress.set(GetPosition()); }

 private:
  Progress m_progress;
};

}  // namespace handwheel
