// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/RecordingsEdit.h"

#include "document/Document.h"

#include <algorithm>
#include <charconv>
#include <utility>

namespace handwheel {

namespace {
constexpr std::size_t kKeyDigits = 4;
}

// The model stays unchanged: a tool in the middle of its work must not be notified.
void RecordingsEdit::exchange(Document& document) {
  document.m_file.recordings.swap(m_recordings);
  document.countChange();
  emit document.fileChanged();
}

// The ticks are mostly shared with the document.
std::size_t RecordingsEdit::bytes() const {
  return sizeof *this + m_recordings.size() * sizeof(StoredRecording);
}

std::string freeKey(const std::vector<StoredRecording>& recordings) {
  unsigned long highest = 0;
  for (const StoredRecording& each : recordings) {
    unsigned long number = 0;
    std::from_chars(each.key.data(), each.key.data() + each.key.size(), number);
    highest = std::max(highest, number);
  }
  const std::string digits = std::to_string(highest + 1);
  return std::string(kKeyDigits - std::min(kKeyDigits, digits.size()), '0') + digits;
}

}  // namespace handwheel
