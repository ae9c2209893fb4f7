// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/recovery/RecoveryFiles.h"
#include "document/recovery/RecoveryLock.h"

#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace handwheel {

struct Container;
struct OrphanedAutosave;
struct StoredAutosave;

// A session that stores and removes the autosaves of a running program. Each session has a folder of its own below the
// root. The folder is created when it is first needed and locked while the session exists. Autosaves that remain at the
// end of the session stay, and can be found by OrphanedAutosaves. The functions may be called on any thread, but the
// autosaves of one key must be stored one after the other.
class RecoverySession {
 public:
  explicit RecoverySession(std::filesystem::path root = recoveryFolder());
  ~RecoverySession();
  RecoverySession(const RecoverySession&) = delete;
  RecoverySession& operator=(const RecoverySession&) = delete;

  // Replaces the autosave of a key with a container, atomically and durably. After a failure, such as a full disk, the
  // older autosave still exists. The key identifies an open document in this session, because two copies of a file have
  // the same document id. Errors: WriteFailed, Cancelled.
  Status store(std::uint64_t key, const AutosaveInfo& info, std::string_view container, Progress progress = {});
  // Stores a container as the autosave of a key. If most of its blobs are already in the autosave of the key, only the
  // other blobs are written, to a separate file. Errors: WriteFailed, and the errors of writeContainer().
  Status store(std::uint64_t key, const AutosaveInfo& info, const Container& container, Progress progress = {});

  // Removes the autosave of a document that no longer differs from its file, and undoes a store() that is still
  // running. Must not be called if the document was changed while it was saved, because that store() may contain the
  // change.
  void remove(std::uint64_t key);
  // Removes the autosave of a document that is closed. A store() that begins later, because its job had to wait, has no
  // effect.
  void close(std::uint64_t key);

  // Moves an autosave of an ended session to this session by renaming its file, so that the autosave exists at every
  // moment. Errors: WriteFailed.
  Status adopt(const OrphanedAutosave& leftover, std::uint64_t key);

 private:
  struct Slot {
    std::uint64_t removals = 0;
    std::optional<AutosaveInfo> info;              // description that is on the disk; nothing: unknown
    std::shared_ptr<const StoredAutosave> stored;  // stored blobs; null: unknown
    bool isClosed = false;
  };

  enum class Part { Whole, Changes };

  Status openFolder();
  Status store(std::uint64_t key, const AutosaveInfo& info, std::string_view bytes,
               std::shared_ptr<const StoredAutosave> stored, Part part, Progress progress);
  Status write(const std::filesystem::path& autosave, const AutosaveInfo& info, bool infoIsThere,
               std::string_view bytes, Part part, Progress progress) const;

  std::mutex m_mutex;  // protects the members below; not held while writing
  std::filesystem::path m_root;
  std::filesystem::path m_folder;
  std::optional<RecoveryLock> m_lock;
  std::map<std::uint64_t, Slot> m_slots;
};

}  // namespace handwheel
