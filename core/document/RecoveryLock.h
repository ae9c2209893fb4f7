// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace handwheel {

// Tells a folder whose owner lives from one whose owner is dead: the owner holds a lock on a file in it, and the system
// takes that back when the process ends, however it ends. Two in one process exclude each other as well.
class RecoveryLock {
 public:
  // None when somebody holds it, or the file system knows no locks, or the folder is gone.
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
