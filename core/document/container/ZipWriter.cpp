// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/ZipWriter.h"

#include <zip.h>
#include <memory>

namespace handwheel {

namespace {

constexpr zip_uint32_t kFastest = 1;               // deflate level
constexpr zip_uint16_t kTime = 0, kDate = 0x0021;  // 1 January 1980, the first that the format knows
constexpr zip_flags_t kNewEntry = ZIP_FL_ENC_UTF_8;

struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct DiscardArchive {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
using Source = std::unique_ptr<zip_source_t, FreeSource>;
using Archive = std::unique_ptr<zip_t, DiscardArchive>;

Error libraryError(zip_error_t* error) {
  const int code = zip_error_code_zip(error);
  if (code == ZIP_ER_CANCELLED) return {ErrorCode::Cancelled, {}, {}, {}};
  if (code == ZIP_ER_MEMORY) return {ErrorCode::OutOfMemory, {}, {}, {}};
  return {ErrorCode::LibraryFailed, {"libzip", zip_error_strerror(error)}, {}, {}};
}

bool addEntry(zip_t* archive, const ZipEntry& entry, Compression compression) {
  zip_source_t* source = zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0);
  if (!source) return false;
  const zip_int64_t index = zip_file_add(archive, std::string(entry.name).c_str(), source, kNewEntry);
  if (index < 0) {
    zip_source_free(source);
    return false;
  }
  const auto at = static_cast<zip_uint64_t>(index);
  const zip_int32_t method = compression == Compression::Fast ? ZIP_CM_DEFLATE : ZIP_CM_STORE;
  return zip_set_file_compression(archive, at, method, kFastest) == 0 &&
         zip_file_set_dostime(archive, at, kTime, kDate, 0) == 0;
}

void watch(zip_t* archive, Progress& progress) {
  zip_register_cancel_callback_with_state(
      archive, [](zip_t*, void* state) { return static_cast<Progress*>(state)->cancelled() ? 1 : 0; }, nullptr,
      &progress);
  zip_register_progress_callback_with_state(
      archive, 0.01, [](zip_t*, double done, void* state) { static_cast<Progress*>(state)->set(done); }, nullptr,
      &progress);
}

Result<std::string> contentOf(zip_source_t* source) {
  zip_stat_t status;
  std::string bytes;
  bool good = zip_source_stat(source, &status) == 0 && zip_source_open(source) == 0;
  if (good) {
    bytes.resize(status.size);
    good = zip_source_read(source, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
    zip_source_close(source);
  }
  if (!good) return libraryError(zip_source_error(source));
  return bytes;
}

}  // namespace

Result<std::string> writeZip(std::span<const ZipEntry> entries, Compression compression, Progress progress) {
  zip_error_t error;
  zip_error_init(&error);
  const Source target(zip_source_buffer_create(nullptr, 0, 0, &error));
  if (!target) return libraryError(&error);
  Archive archive(zip_open_from_source(target.get(), ZIP_TRUNCATE, &error));
  if (!archive) return libraryError(&error);
  zip_source_keep(target.get());  // the archive owns one reference, we the other
  for (const ZipEntry& entry : entries) {
    if (!addEntry(archive.get(), entry, compression)) return libraryError(zip_get_error(archive.get()));
  }
  watch(archive.get(), progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (zip_close(archive.get()) != 0) return libraryError(zip_get_error(archive.get()));
  (void)archive.release();
  return contentOf(target.get());
}

}  // namespace handwheel
