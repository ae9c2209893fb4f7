// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/vdb/VdbFile.h"

#include "process/IsolatedReader.h"

namespace handwheel {
namespace {

Result<std::string> byProcess(const char* task, std::string_view bytes, Progress progress) {
  IsolatedReader reader{readerProgram("vdb"), kVdbLibrary, {}};
  // The process reads about ten megabytes per second; the limit allows for slow machines. Some damaged files take all
  // the time they get.
  reader.limits.cpu = std::chrono::seconds(20 + (bytes.size() >> 20));
  reader.limits.wall = 2 * reader.limits.cpu;
  return readIsolated(reader, {task}, bytes, progress);
}

}  // namespace

bool looksLikeVdb(std::string_view bytes) {
  return bytes.starts_with(std::string_view(" BDV\0\0\0\0", 8));
}

Result<VdbVolume> readVdb(std::string_view file, Progress progress) {
  const Result<std::string> answer = byProcess("read", file, progress.part(0.0, 0.9));
  if (!answer) return answer.error();
  std::optional<VdbVolume> read = vdbVolumeIn(*answer);
  if (!read) return Error{ErrorCode::LibraryFailed, {kVdbLibrary, "its answer is not valid"}, {}, {}};
  return std::move(*read);
}

Result<std::string> vdbOf(const SparseVolume& volume, Progress progress) {
  Result<std::string> file = byProcess("write", bytesOf(VdbVolume{volume}), progress);
  if (file && !looksLikeVdb(*file))
    return Error{ErrorCode::LibraryFailed, {kVdbLibrary, "its answer is not valid"}, {}, {}};
  return file;
}

}  // namespace handwheel
