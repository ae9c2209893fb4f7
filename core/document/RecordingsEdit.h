// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/KeptRecording.h"

#include <vector>

namespace handwheel {

// Changes the recordings of a document: adds, removes or renames one.
class RecordingsEdit : public Edit {
 public:
  explicit RecordingsEdit(std::vector<KeptRecording> recordings) : m_recordings(std::move(recordings)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::vector<KeptRecording> m_recordings;
};

// A key that none of the recordings has.
std::string freeKey(const std::vector<KeptRecording>& recordings);

}  // namespace handwheel
