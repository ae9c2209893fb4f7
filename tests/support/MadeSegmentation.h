// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MadeFrames.h"

namespace handwheel::test {

// A segment of an artificial segmentation.
struct MadeSegment {
  std::string name;
  std::function<bool(const Vec3&)> contains;
};

// An artificial segmentation in DICOM (PS3.3, A.51), written by GDCM. Its grid is that of `slices`, from the lowest.
struct MadeSegmentation {
  enum class Kind { Binary, Fractional, LabelMap };
  Kind kind = Kind::Binary;
  std::vector<MadeSlice> slices = {};
  std::vector<MadeSegment> segments = {};
  std::optional<double> between = {};    // SpacingBetweenSlices, mm
  std::optional<double> thickness = {};  // SliceThickness, mm
  bool hasEmptyFrames = false;           // false: frames without a sample of their segment are left out
  int fractions = 255;                   // MaximumFractionalValue
};

inline std::string dicomOf(const MadeSegmentation& made) {
  using namespace made_frames;
  using Kind = MadeSegmentation::Kind;
  gdcm::Trace::WarningOff();
  gdcm::Writer writer;
  gdcm::DataSet& data = writer.GetFile().GetDataSet();
  const MadeSlice& first = made.slices.front();
  const bool isMap = made.kind == Kind::LabelMap, isBinary = made.kind == Kind::Binary;
  putText(data, {0x0008, 0x0016}, gdcm::VR::UI,
          isMap ? "1.2.840.10008.5.1.4.1.1.66.7" : "1.2.840.10008.5.1.4.1.1.66.4");
  putText(data, {0x0008, 0x0018}, gdcm::VR::UI, "1.2.3.4.5.7");
  putText(data, {0x0008, 0x0060}, gdcm::VR::CS, "SEG");
  putText(data, {0x0020, 0x000e}, gdcm::VR::UI, "1.2.3.4.66");
  putText(data, {0x0062, 0x0001}, gdcm::VR::CS, isMap ? "LABELMAP" : isBinary ? "BINARY" : "FRACTIONAL");
  if (made.kind == Kind::Fractional)
    putCount(data, {0x0062, 0x000e}, gdcm::VR::US, static_cast<std::uint16_t>(made.fractions));
  std::vector<gdcm::DataSet> segments;
  for (std::size_t i = 0; i < made.segments.size(); ++i) {
    segments.emplace_back();
    putCount(segments.back(), {0x0062, 0x0004}, gdcm::VR::US, static_cast<std::uint16_t>(i + 1));
    putText(segments.back(), {0x0062, 0x0005}, gdcm::VR::LO, made.segments[i].name);
  }
  putItems(data, {0x0062, 0x0002}, segments);
  std::vector<gdcm::DataSet> groups;
  std::vector<int> pixels;  // one for each pixel of each frame
  const auto put = [&](const MadeSlice& slice, std::size_t segment, auto valueAt) {
    std::vector<int> own;
    for (int y = 0; y < slice.height; ++y)
      for (int x = 0; x < slice.width; ++x) own.push_back(valueAt(slice.position(x, y)));
    if (!made.hasEmptyFrames && std::all_of(own.begin(), own.end(), [](int v) { return v == 0; })) return;
    pixels.insert(pixels.end(), own.begin(), own.end());
    groups.emplace_back();
    gdcm::DataSet position, number;
    putPosition(position, slice.origin);
    putItems(groups.back(), {0x0020, 0x9113}, {position});
    if (isMap) return;
    putCount(number, {0x0062, 0x000b}, gdcm::VR::US, static_cast<std::uint16_t>(segment + 1));
    putItems(groups.back(), {0x0062, 0x000a}, {number});
  };
  if (isMap)
    for (const MadeSlice& slice : made.slices)
      put(slice, 0, [&](const Vec3& p) {
        int value = 0;
        for (std::size_t i = 0; i < made.segments.size(); ++i)
          if (made.segments[i].contains(p)) value = static_cast<int>(i + 1);
        return value;
      });
  for (std::size_t i = 0; i < made.segments.size() && !isMap; ++i)
    for (const MadeSlice& slice : made.slices)
      put(slice, i, [&](const Vec3& p) {
        // Fractions: more than a half within, and less just outside.
        if (made.segments[i].contains(p)) return isBinary ? 1 : (made.fractions * 3 + 3) / 4;
        return !isBinary && made.segments[i].contains(p - Vec3(0.9, 0, 0)) ? made.fractions / 4 : 0;
      });
  gdcm::DataSet measures, turn, shared;
  putNumbers(measures, {0x0028, 0x0030}, {first.downSpacing.value_or(first.spacing), first.spacing});
  if (made.between) putNumbers(measures, {0x0018, 0x0088}, {*made.between});
  if (made.thickness) putNumbers(measures, {0x0018, 0x0050}, {*made.thickness});
  putOrientation(turn, first);
  putItems(shared, {0x0028, 0x9110}, {measures});
  putItems(shared, {0x0020, 0x9116}, {turn});
  putItems(data, {0x5200, 0x9229}, {shared});
  putItems(data, {0x5200, 0x9230}, groups);
  putText(data, {0x0028, 0x0004}, gdcm::VR::CS, "MONOCHROME2");
  putText(data, {0x0028, 0x0008}, gdcm::VR::IS, std::to_string(groups.size()));
  const std::uint16_t bits = isBinary ? 1 : 8;
  putCount(data, {0x0028, 0x0002}, gdcm::VR::US, std::uint16_t{1});
  putCount(data, {0x0028, 0x0010}, gdcm::VR::US, static_cast<std::uint16_t>(first.height));
  putCount(data, {0x0028, 0x0011}, gdcm::VR::US, static_cast<std::uint16_t>(first.width));
  putCount(data, {0x0028, 0x0100}, gdcm::VR::US, bits);
  putCount(data, {0x0028, 0x0101}, gdcm::VR::US, bits);
  putCount(data, {0x0028, 0x0102}, gdcm::VR::US, static_cast<std::uint16_t>(bits - 1));
  putCount(data, {0x0028, 0x0103}, gdcm::VR::US, std::uint16_t{0});
  std::string bytes(isBinary ? (pixels.size() + 7) / 8 : pixels.size(), '\0');
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (isBinary)
      bytes[i / 8] = static_cast<char>(bytes[i / 8] | pixels[i] << i % 8);
    else
      bytes[i] = static_cast<char>(pixels[i]);
  }
  if (bytes.size() % 2 != 0) bytes += '\0';
  gdcm::DataElement element(gdcm::Tag(0x7fe0, 0x0010));
  element.SetVR(gdcm::VR::OB);
  element.SetByteValue(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  data.Replace(element);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  std::ostringstream stream;
  writer.SetStream(stream);
  return writer.Write() ? stream.str() : std::string();
}

}  // namespace handwheel::test
