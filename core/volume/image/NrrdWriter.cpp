// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NrrdWriter.h"

#include "base/ByteOrder.h"
#include "base/NumberText.h"

namespace handwheel {
namespace {

std::string vectorText(const Vec3& v) {
  return "(" + shortestText(v.x()) + "," + shortestText(v.y()) + "," + shortestText(v.z()) + ")";
}

}  // namespace

void appendNrrd(const ImageVolume& image, const std::string& content, std::string& file) {
  const ImageGrid& grid = image.grid();
  file += "NRRD0004\ntype: ";
  file += image.isWhole() ? "int16" : "float";
  if (!content.empty()) file += "\ncontent: " + content;
  file += "\ndimension: 3\nspace: left-posterior-superior\nsizes:";
  for (const int n : grid.size) file += " " + std::to_string(n);
  file += "\nspace directions:";
  for (Eigen::Index k = 0; k < 3; ++k) file += " " + vectorText(grid.steps.col(k));
  file +=
      "\nspace units: \"mm\" \"mm\" \"mm\"\nkinds: domain domain domain\nendian: little\nencoding: raw\nspace "
      "origin: " +
      vectorText(grid.origin) + "\n\n";
  image.visitSamples([&](auto samples) {
    if constexpr (std::endian::native == std::endian::little) {
      file.append(reinterpret_cast<const char*>(samples.data()), samples.size_bytes());
    } else {
      for (const auto v : samples) appendNumber(file, v, std::endian::little);
    }
  });
}

std::string nrrdOf(const ImageVolume& image, const std::string& content) {
  std::string file;
  appendNrrd(image, content, file);
  return file;
}

}  // namespace handwheel
