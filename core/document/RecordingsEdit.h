// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/StoredRecording.h"

#include <vector>

namespace handwheel {

// An edit that replaces the list of recordings of a document.
class RecordingsEdit : public Edit {
 public:
  explicit RecordingsEdit(std::vector<StoredRecording> recordings) : m_recordings(std::move(recordings)) {}

  void exchange(Document& document) override;
  std::size_t bytes() const override;

 private:
  std::vector<StoredRecording> m_recordings;
};

// Returns a new key that no recording in the list has.
std::string freeKey(const std::vector<StoredRecording>& recordings);

}  // namespace handwheel
