// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/FileBytes.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace handwheel {

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

using OpenFile = std::unique_ptr<std::FILE, CloseFile>;

Error unreadable(int number) {
  return {ErrorCode::FileUnreadable, {std::generic_category().message(number)}, {}, {}};
}

Result<OpenFile> openFile(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  if (std::filesystem::is_directory(status)) return unreadable(EISDIR);
  // A device or a pipe may never end.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    return Error{ErrorCode::FileUnreadable, {"Not a regular file"}, {}, {}};
  OpenFile file(std::fopen(path.c_str(), "rb"));
  if (!file && errno == ENOENT) return Error{ErrorCode::FileMissing, {}, {}, {}};
  if (!file) return unreadable(errno);
  return file;
}

}  // namespace

// Reads in blocks, for progress and cancellation. Not memory-mapped: if another program truncates the file, we would
// crash.
Result<std::string> readFileBytes(const std::filesystem::path& path, Progress progress) {
  const Result<OpenFile> file = openFile(path);
  if (!file) return file.error();
  constexpr std::size_t kReadAtOnce = std::size_t{4} << 20;
  std::error_code failed;
  const auto expected = std::filesystem::file_size(path, failed);
  std::string bytes;
  if (!failed) bytes.reserve(static_cast<std::size_t>(expected) + kReadAtOnce);
  for (;;) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const std::size_t before = bytes.size();
    bytes.resize(before + kReadAtOnce);
    const std::size_t got = std::fread(bytes.data() + before, 1, kReadAtOnce, file->get());
    bytes.resize(before + got);
    if (std::ferror(file->get())) return unreadable(errno);
    if (got < kReadAtOnce) return bytes;
    if (!failed && expected > 0)
      progress.set(std::min(1.0, static_cast<double>(bytes.size()) / static_cast<double>(expected)));
  }
}

Result<std::string> readFileHead(const std::filesystem::path& path, std::size_t most) {
  const Result<OpenFile> file = openFile(path);
  if (!file) return file.error();
  std::string bytes(most, '\0');
  bytes.resize(std::fread(bytes.data(), 1, most, file->get()));
  if (std::ferror(file->get())) return unreadable(errno);
  return bytes;
}

}  // namespace handwheel
