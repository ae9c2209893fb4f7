// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"
#include "document/recovery/RecoveryFiles.h"
#include "document/recovery/RecoveryLock.h"

#include <vector>

namespace handwheel {

// An autosave that a session left when it ended or was killed.
struct OrphanedAutosave {
  AutosaveInfo info;           // empty if it is damaged; the container knows its id and kind
  std::filesystem::path file;  // a container; to be read after joinChanges()
  std::uint64_t bytes = 0;
  std::int64_t savedAt = 0;  // milliseconds since 1970
  bool isOutdated = false;   // its file was written later
};

// The autosaves that dead sessions left below a root folder. This object holds their locks, so that no other window
// offers the same. Nothing is deleted until it is discarded; autosaves that are neither discarded nor adopted
// (Recovery.h) are found again the next time.
class OrphanedAutosaves {
 public:
  explicit OrphanedAutosaves(const std::filesystem::path& root = recoveryFolder());
  // Returns the autosaves of some sessions alone: of inUse(), if their programs may have ended meanwhile.
  static OrphanedAutosaves of(const std::vector<std::filesystem::path>& sessions);
  ~OrphanedAutosaves();
  OrphanedAutosaves(OrphanedAutosaves&&) = default;
  OrphanedAutosaves& operator=(OrphanedAutosaves&&) = delete;

  const std::vector<OrphanedAutosave>& found() const { return m_found; }  // the newest first
  // Returns files too damaged to be autosaves, or changes of them: EntryDamaged {name}; subject: its path.
  const std::vector<Error>& skipped() const { return m_skipped; }

  // Returns the folders of sessions that others have locked.
  const std::vector<std::filesystem::path>& inUse() const { return m_inUse; }

  void discard(const OrphanedAutosave& leftover) const;
  void discardSkipped() const;

 private:
  struct Session {
    std::filesystem::path folder;
    RecoveryLock lock;
  };

  struct Nothing {};
  explicit OrphanedAutosaves(Nothing) {}

  void list(const std::vector<std::filesystem::path>& folders);
  void list(const std::filesystem::path& folder);
  void look(const std::filesystem::path& file);

  std::vector<Session> m_sessions;
  std::vector<OrphanedAutosave> m_found;
  std::vector<Error> m_skipped;
  std::vector<std::filesystem::path> m_inUse;
};

namespace recovery {

inline constexpr char kHiddenPrefix = '.';  // prefix of a session folder that is not locked yet

// Removes a session's folder unless an autosave is in it. The caller holds its lock.
void removeIfEmpty(const std::filesystem::path& session);

}  // namespace recovery

}  // namespace handwheel
