// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/container/ZipWriter.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// In-memory content of a file "*.handwheel": a manifest and blobs. The file is a ZIP archive with the entry
// manifest.json and one entry per blob; docs/format.md describes the format.
struct Container {
  Container();
  Container(const Container&);
  Container(Container&&) noexcept;
  Container& operator=(const Container&);
  Container& operator=(Container&&) noexcept;
  ~Container();

  std::unique_ptr<nlohmann::json> manifest;  // never null; an object
  std::map<std::string, std::string> blobs;  // by entry name, "mesh/positions/0000"
  std::filesystem::path folder;              // absolute folder of the file; empty: unknown; not part of the content
};

// Result of reading a container.
struct ReadContainer {
  Container container;        // migrated to the present version of the format
  std::vector<Error> damage;  // entries that are missing or damaged; empty if the file is whole
  bool isNewer = false;       // a newer version of the program wrote the file
};

// Version of the format; see container/Migrations.h.
inline constexpr int kContainerVersion = 5;
// Largest unpacked size of all entries together, bytes. Larger containers are neither written nor read, so that every
// size fits into 32 bits.
inline constexpr std::uint64_t kLargestContainer = std::uint64_t{3} << 30;

// Serialises a container to the bytes of its archive. The version in the manifest's object "handwheel" and the object
// "blobs" (sizes and checksums) are filled in; other keys of "handwheel" stay. Equal containers give equal bytes.
// Errors: Cancelled, OutOfMemory, FileTooLarge, LibraryFailed.
Result<std::string> writeContainer(const Container& container, Compression compression, Progress progress = {});

// Reads a container from untrusted bytes. Memory is bounded (at most kLargestContainer unpacked), and so is recursion.
// If the archive's directory is lost or wrong, entries are searched for one by one. The manifest is returned without
// "blobs", which describes the file only. Fails only if no manifest can be read or the archive is too large. Errors:
// FileEmpty, ArchiveMalformed {library's reason}, EntryMissing and EntryDamaged {manifest.json}, ElementMalformed,
// FileTooLarge, OutOfMemory, Cancelled.
Result<ReadContainer> readContainer(std::string_view bytes, Progress progress = {});

// Returns true if bytes look like the beginning of a container. The first 64 KiB are enough.
bool looksLikeContainer(std::string_view bytes);

// Converts numbers to little-endian bytes, the form of all blobs. T: double, float, whole numbers of 8 to 64 bits. Long
// arrays are written by writeArray() (container/Blobs.h).
template <class T>
std::string toBlob(const std::vector<T>& values);
// Converts a blob to numbers. Remaining bytes that do not form a whole element are dropped.
template <class T>
std::vector<T> fromBlob(std::string_view blob);

}  // namespace handwheel
