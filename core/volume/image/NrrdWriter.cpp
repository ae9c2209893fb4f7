// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NrrdWriter.h"

#include "base/ByteOrder.h"
#include "base/NumberText.h"

#include <algorithm>

namespace handwheel {
namespace {

std::string vectorText(const Vec3& v) {
  return "(" + shortestText(v.x()) + "," + shortestText(v.y()) + "," + shortestText(v.z()) + ")";
}

// The keys are those of 3D Slicer.
void appendLabels(const std::vector<ImageLabel>& labels, std::string& file) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    std::string name = labels[i].name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
    const std::string key = "Segment" + std::to_string(i) + "_";
    file += key + "LabelValue:=" + shortestText(labels[i].value) + "\n" + key + "Name:=" + name + "\n";
  }
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
      vectorText(grid.origin) + "\n";
  appendLabels(image.labels(), file);
  file += '\n';
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
