// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/container/UnpackLimits.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// Reads an untrusted ZIP archive from memory. If its directory is lost or wrong, entries are found by their local
// headers. The bytes must outlive it; one thread at a time. May throw bad_alloc.
class ZipReader {
 public:
  // progress: for cancelling only.
  ZipReader(std::string_view archive, const UnpackLimits& limits, Progress progress = {});
  ~ZipReader();

  // The names of the entries, from the directory or else from the headers; each once, in their order. They are not
  // validated.
  const std::vector<std::string>& names() const;

  // Bytes of the entry as declared in the directory or its header, true or not; 0 when it does not exist.
  std::uint64_t announcedSize(const std::string& name) const;

  // The entry, whole and with the right checksum. Errors: EntryMissing {name}, EntryDamaged {name}, FileTooLarge
  // {"bytes", "", limit}, Cancelled.
  Result<std::string> read(const std::string& name);
  // What can be unpacked of a damaged entry, from its beginning; possibly nothing.
  std::string readDamaged(const std::string& name);

  // Why the directory cannot be used; empty when it can.
  const std::string& directoryProblem() const;
  // Names that the directory lists more than once; the first is read.
  const std::vector<std::string>& duplicates() const;
  // Whether an entry was read that the directory does not lead to.
  bool hasSalvaged() const;

 private:
  class Archive;
  std::unique_ptr<Archive> m_archive;
};

}  // namespace handwheel
