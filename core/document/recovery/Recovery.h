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

// Stores and removes the autosaves of a running program. They are in a folder of its own below the root, created when
// it is first needed and locked while the session exists. Autosaves that remain at its end stay, and can be found as
// those of a dead session (OrphanedAutosaves.h). Any thread; the autosaves of one key are stored one after the other.
class RecoverySession {
 public:
  explicit RecoverySession(std::filesystem::path root = recoveryFolder());
  ~RecoverySession();
  RecoverySession(const RecoverySession&) = delete;
  RecoverySession& operator=(const RecoverySession&) = delete;

  // Replaces the key's autosave by a container, atomically and durably; after a failure, such as a full disk, the older
  // one is still there. The key identifies the open document in this session: two copies of a file have the same
  // document id. Errors: WriteFailed, Cancelled.
  Status store(std::uint64_t key, const AutosaveInfo& info, std::string_view container, Progress progress = {});
  // Stores a container; if most of its blobs are in the key's autosave already, only the others are written, beside it.
  // Errors: those of writeContainer(), too.
  Status store(std::uint64_t key, const AutosaveInfo& info, const Container& container, Progress progress = {});

  // Removes the autosave, because the document no longer differs from its file. Must not be called if it was changed
  // again while it was saved: a store() that is under way may hold that change, and is undone.
  void remove(std::uint64_t key);
  // Removes the autosave, because the document is closed. A store() that begins only now, because its job had to wait,
  // leaves nothing either.
  void close(std::uint64_t key);

  // Takes over an autosave of a dead session, by renaming: at every moment one of the two has it. Errors: WriteFailed.
  Status adopt(const OrphanedAutosave& leftover, std::uint64_t key);

 private:
  struct Slot {
    std::uint64_t removals = 0;
    std::optional<AutosaveInfo> info;              // present state on the disk
    std::shared_ptr<const StoredAutosave> stored;  // stored blobs; null: unknown
    bool isClosed = false;
  };

  enum class Part { Whole, Changes };

  Status openFolder();
  Status store(std::uint64_t key, const AutosaveInfo& info, std::string_view bytes,
               std::shared_ptr<const StoredAutosave> stored, Part part, Progress progress);
  Status write(const std::filesystem::path& autosave, const AutosaveInfo& info, bool infoIsThere,
               std::string_view bytes, Part part, Progress progress) const;

  std::mutex m_mutex;  // protects all below; not held while writing
  std::filesystem::path m_root;
  std::filesystem::path m_folder;
  std::optional<RecoveryLock> m_lock;
  std::map<std::uint64_t, Slot> m_slots;
};

}  // namespace handwheel
