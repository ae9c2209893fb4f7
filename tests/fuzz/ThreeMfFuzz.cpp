// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/container/ZipWriter.h"
#include "document/formats/MeshFormat.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is a 3MF file; or, where it
// is no archive, the text of its model, so that changes get past the checksums. Its length chooses the mode.

using namespace handwheel;

namespace {

constexpr std::string_view kRelationships =
    "<Relationships><Relationship Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel' "
    "Target='/a.model'/></Relationships>";

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ThreeMfFuzz: %s\n", what);
  std::abort();
}

void judge(const MeshFile& file) {
  const auto& [points, triangles] = file.soup;
  for (const auto& p : points) require(p.allFinite(), "a point is not finite");
  for (const auto& t : triangles)
    for (std::uint32_t corner : t) require(corner < points.size(), "an index is out of range");
  require(!triangles.empty(), "a mesh without triangles");
  require(file.damage.size() <= 1000, "too much listed");
}

void writeAndRead(const MeshFile& file) {
  const auto again = readMesh(writeMesh(file.soup, MeshFormat::ThreeMf, NumberType::Float64), "", {});
  require(again.hasValue() && again->damage.empty() && again->lost.empty(), "what was written is not read");
  require(again->soup.triangles == file.soup.triangles && again->soup.points == file.soup.points,
          "what was written is read differently");
}

std::string package(std::string_view model) {
  const ZipEntry entries[] = {{"_rels/.rels", kRelationships}, {"a.model", model}, {"b.model", model}};
  const auto archive = writeZip(entries, Compression::None);
  require(archive.hasValue(), "no archive");
  return *archive;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const std::string archive = bytes.starts_with("PK") ? std::string(bytes) : package(bytes);
  const auto file = readMesh(archive, "a.3mf", {.partial = size % 2 == 1});
  if (!file) return 0;
  judge(*file);
  if (file->soup.triangles.size() < 1000) writeAndRead(*file);
  return 0;
}
