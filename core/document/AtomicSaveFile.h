// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace handwheel {

// The folder of a file; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

// Temporary file that replaces another file when it is complete. If the system supports it, it has no name until it is
// complete, so that a program killed while writing leaves nothing; elsewhere (network and foreign file systems) it is a
// hidden file next to the other. Removed with this object unless it replaced the target. A file that a killed program
// did leave is removed by the next one for the same target: running programs hold a lock on theirs. One thread at a
// time.
class AtomicSaveFile {
 public:
  explicit AtomicSaveFile(const std::filesystem::path& target);
  ~AtomicSaveFile();
  AtomicSaveFile(const AtomicSaveFile&) = delete;
  AtomicSaveFile& operator=(const AtomicSaveFile&) = delete;

  int descriptor() const { return m_descriptor; }  // for writing; negative: none, errno is the reason

  // Replaces the target, which at every moment is completely the old file or this one. False: errno is the reason, and
  // it is the old one.
  bool takePlace();

  // ".handwheel-", eight hexadecimal digits made of the target's name, which may be as long as names can be, and a
  // number.
  static std::filesystem::path hiddenName(const std::filesystem::path& target, int number);

 private:
  bool create(const std::filesystem::path& name);
  bool link(const std::filesystem::path& name);
  // With the first hidden name for which it does not fail because there is such a file.
  bool withHiddenName(bool (AtomicSaveFile::*make)(const std::filesystem::path&));

  std::filesystem::path m_target;
  std::filesystem::path m_name;  // empty while it has none
  int m_descriptor = -1;
};

}  // namespace handwheel
