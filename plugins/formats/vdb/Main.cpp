// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/ReaderProgram.h"
#include "vdb/VdbGrid.h"

#include <openvdb/io/Stream.h>
#include <new>
#include <sstream>

// Reads and writes VDB for core/volume/vdb/VdbFile.cpp. With the option "read" its input is the file, and the answer a
// volume (VdbVolume.h); with "write" vice versa.

using namespace handwheel;

namespace {

Result<std::string> readGrids(std::string_view bytes) {
  std::istringstream stream{std::string(bytes)};
  const openvdb::GridPtrVecPtr grids = openvdb::io::Stream(stream, false).getGrids();
  const Result<VdbVolume> volume = volumeOfGrids(*grids);
  return volume ? Result<std::string>(bytesOf(*volume)) : volume.error();
}

Result<std::string> writeGrid(std::string_view bytes) {
  const std::optional<VdbVolume> volume = vdbVolumeIn(bytes);
  if (!volume) return Error{ErrorCode::LibraryFailed, {"it is inconsistent"}, {}, {}};
  std::ostringstream stream;
  openvdb::io::Stream(stream).write(openvdb::GridPtrVec{gridOf(volume->volume)});
  return stream.str();
}

Result<std::string> answerVdb(std::string_view bytes, std::span<char* const> options, Progress) {
  try {
    openvdb::initialize();
    return !options.empty() && std::string_view(options[0]) == "write" ? writeGrid(bytes) : readGrids(bytes);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return Error{ErrorCode::LibraryFailed, {"it is inconsistent"}, {}, {}};
  }
}

}  // namespace

int main(int argc, char** argv) {
  runReaderProgram(argc, argv, answerVdb);
}
