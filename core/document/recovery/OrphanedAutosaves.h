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
  AutosaveInfo info;           // empty if it is damaged; the container also has the document's id and kind
  std::filesystem::path file;  // a container; must be read after joinChanges()
  std::uint64_t bytes = 0;
  std::int64_t savedAt = 0;  // milliseconds since 1970
  bool isOutdated = false;   // the document's file was written later
};

// The autosaves that ended sessions left below a root folder. This object locks the sessions, so that no other window
// offers their autosaves. Autosaves that are neither discarded nor adopted (Recovery.h) are kept and found again the
// next time.
class OrphanedAutosaves {
 public:
  explicit OrphanedAutosaves(const std::filesystem::path& root = recoveryFolder());
  // Returns the autosaves of some sessions only, for example of inUse() when their programs may have ended.
  static OrphanedAutosaves of(const std::vector<std::filesystem::path>& sessions);
  ~OrphanedAutosaves();
  OrphanedAutosaves(OrphanedAutosaves&&) = default;
  OrphanedAutosaves& operator=(OrphanedAutosaves&&) = delete;

  const std::vector<OrphanedAutosave>& found() const { return m_found; }  // newest first
  // Returns errors for the autosaves, and changes of autosaves, that are too damaged to be read. The subject of an
  // error is the path of the file.
  const std::vector<Error>& skipped() const { return m_skipped; }

  // Returns the folders of sessions that are locked by other programs or objects.
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

// Removes the folder of a session unless it contains an autosave or damaged changes of one. The caller must hold its
// lock.
void removeIfEmpty(const std::filesystem::path& session);

}  // namespace recovery

}  // namespace handwheel
