// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFormat.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the file; its length
// chooses the ending of its name and the mode.

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "MeshReaderFuzz: %s\n", what);
  std::abort();
}

void judge(const handwheel::Result<handwheel::MeshFile>& file) {
  if (!file) return;
  const auto& [points, triangles] = file->soup;
  for (const auto& p : points) require(p.allFinite(), "a point is not finite");
  for (const auto& t : triangles)
    for (std::uint32_t corner : t) require(corner < points.size(), "an index is out of range");
  require(!triangles.empty(), "a mesh without triangles");
  require(file->damage.size() <= 1000, "too much listed");
}

// Writes a mesh that was read, and checks that reading it again gives the same number of triangles. STL cannot store
// doubles beyond single precision, so the other formats stand for it.
void writeAndRead(const handwheel::MeshFile& file, handwheel::MeshFormat format) {
  const std::string bytes = handwheel::writeMesh(file.soup, format, handwheel::NumberType::Float64);
  const auto again = handwheel::readMesh(bytes, "", {});
  require(again.hasValue() && again->damage.empty(), "what was written is not read");
  require(again->soup.triangles == file.soup.triangles, "what was written is read differently");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr const char* kNames[] = {"a.stl", "a.ply", "a.obj", "a.off", ""};
  const char* name = kNames[size / 2 % 5];
  const handwheel::ReadOptions options{.partial = size % 2 == 1};
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto file = handwheel::readMesh(bytes, name, options);
  judge(file);
  if (file && file->soup.points.size() < 1000) {
    constexpr handwheel::MeshFormat kWritten[] = {handwheel::MeshFormat::Ply, handwheel::MeshFormat::Obj,
                                                  handwheel::MeshFormat::Off};
    writeAndRead(*file, kWritten[size % 3]);
  }
  return 0;
}
