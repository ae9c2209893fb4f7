// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "FileChanges.h"
#include "volume/VolumeShapes.h"
#include "volume/vdb/VdbFile.h"

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input changes a VDB file of a
// ball: whatever OpenVDB makes of it in its process, it ends in a volume or an error.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "VdbFileFuzz: %s\n", what);
  std::abort();
}

std::string vdbOfBall() {
  const Result<std::string> file = vdbOf(ballOfVoxels(2.0, 0.3), {});
  require(file.hasValue(), "a ball that cannot be written");
  return *file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string good = vdbOfBall();
  fuzz::ReadingTime time;
  const Result<VdbVolume> read = readVdb(fuzz::changedFile(good, data, size), time.progress());
  if (!read) {
    fuzz::requireReaderError(read.error().code, "VdbFileFuzz");
    return 0;
  }
  require(read->volume.origin().allFinite() && read->volume.voxel() > 0.0 && !read->volume.isEmpty(),
          "a volume that is none");
  return 0;
}
