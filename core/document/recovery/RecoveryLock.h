// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace handwheel {

// A lock file that marks a folder as used by a running process. The owner holds a lock on a file in the folder. The
// system releases the lock when the process ends, for any reason. Two locks in one process exclude each other as well.
class RecoveryLock {
 public:
  // Locks a folder. Returns nothing if the folder is locked already or does not exist, or if its file system does not
  // support locks.
  static std::optional<RecoveryLock> tryLock(const std::filesystem::path& folder);

  RecoveryLock(RecoveryLock&& other) noexcept;
  RecoveryLock& operator=(RecoveryLock&& other) noexcept;
  ~RecoveryLock();

  static constexpr const char* kFileName = "lock";

 private:
  explicit RecoveryLock(int descriptor) : m_descriptor(descriptor) {}
  int m_descriptor;
};

}  // namespace handwheel
