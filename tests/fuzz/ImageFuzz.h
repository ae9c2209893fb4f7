// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/image/ImageFile.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace handwheel::fuzz {

// Checks a reader of images with any file. The second half of the bytes serves as the file beside the image.
template <class Read>
void checkImage(const std::uint8_t* data, std::size_t size, Read read) {
  const auto require = [](bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "image: %s\n", what);
    std::abort();
  };
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Result<ImageFile> file = read(bytes, [&](const std::string&, std::size_t most) -> Result<std::string> {
    return std::string(bytes.substr(size / 2, most));
  });
  if (!file) return;
  const ImageVolume& image = file->image;
  require(checkGrid(image.grid()).hasValue(), "a grid that is refused elsewhere");
  image.visitSamples([&](auto samples) {
    require(samples.size() == image.grid().count(), "other than as many samples as the grid has");
    for (const auto v : samples) require(std::isfinite(static_cast<double>(v)), "a value that is not finite");
  });
}

}  // namespace handwheel::fuzz
