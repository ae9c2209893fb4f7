// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/recovery/RecoveryFiles.h"

#include <QTemporaryDir>
#include <filesystem>

namespace handwheel::test {

// A copy of the autosaves that a window left, with which several tests begin.
class KeptAutosaves {
 public:
  bool isTaken() const { return m_isTaken; }
  void take() {
    std::filesystem::copy(recoveryFolder(), folder(), std::filesystem::copy_options::recursive);
    m_isTaken = true;
  }
  void putBack() const {
    constexpr auto kOptions =
        std::filesystem::copy_options::recursive | std::filesystem::copy_options::overwrite_existing;
    std::filesystem::create_directories(recoveryFolder());
    std::filesystem::copy(folder(), recoveryFolder(), kOptions);
  }

 private:
  std::filesystem::path folder() const { return m_folder.filePath("copy").toStdString(); }

  QTemporaryDir m_folder;
  bool m_isTaken = false;
};

}  // namespace handwheel::test
