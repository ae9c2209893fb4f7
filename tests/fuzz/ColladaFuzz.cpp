// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/cell/ColladaReader.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the file.

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ColladaFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto mesh = handwheel::readCollada({reinterpret_cast<const char*>(data), size});
  if (!mesh) return 0;
  require(!mesh->soup.triangles.empty(), "a mesh without triangles");
  require(mesh->damage.size() <= 1000, "too much listed");
  for (const auto& t : mesh->soup.triangles)
    for (std::uint32_t corner : t) require(corner < mesh->soup.points.size(), "an index is out of range");
  return 0;
}
