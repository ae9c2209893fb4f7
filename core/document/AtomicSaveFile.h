// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace handwheel {

// Returns the folder of a file; "." for a bare name.
std::filesystem::path folderOf(const std::filesystem::path& file);

// A temporary file that replaces another file when it is complete. If the system supports it, the temporary file has no
// name until it is complete, so that a program killed while writing leaves no file. Otherwise (network and foreign file
// systems) it is a hidden file next to the target. It is removed with this object unless it replaced the target. A file
// left by a killed program is removed by the next object for the same target; running programs hold a lock on their
// files. This object must not be used on two threads at the same time.
class AtomicSaveFile {
 public:
  explicit AtomicSaveFile(const std::filesystem::path& target);
  ~AtomicSaveFile();
  AtomicSaveFile(const AtomicSaveFile&) = delete;
  AtomicSaveFile& operator=(const AtomicSaveFile&) = delete;

  int descriptor() const { return m_descriptor; }  // for writing; negative: no file, errno has the reason

  // Replaces the target, which at every moment has either its complete old content or the complete new one. Returns
  // false on failure; errno then has the reason, and the target is unchanged.
  bool replaceTarget();

  // Returns a hidden name for a temporary file: ".handwheel-", eight hexadecimal digits and a number. The digits are a
  // hash of the target's name, which may itself have the maximal length.
  static std::filesystem::path hiddenName(const std::filesystem::path& target, int number);

 private:
  bool create(const std::filesystem::path& name);
  bool link(const std::filesystem::path& name);
  // Calls `make` with the first hidden name that no existing file has.
  bool withHiddenName(bool (AtomicSaveFile::*make)(const std::filesystem::path&));

  std::filesystem::path m_target;
  std::filesystem::path m_name;  // empty while the temporary file has no name
  int m_descriptor = -1;
};

}  // namespace handwheel
