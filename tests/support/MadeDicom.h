// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Geometry.h"

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageWriter.h>
#include <gdcmTrace.h>
#include <cmath>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace handwheel::test {

// A slice of an artificial CT, written by GDCM.
struct MadeSlice {
  int width = 8, height = 6;
  Vec3 origin = Vec3::Zero();
  Vec3 across = Vec3::UnitX(), down = Vec3::UnitY();
  double spacing = 0.5;               // distance of pixels, mm
  std::optional<double> downSpacing;  // distance of rows; none: the same
  double slope = 1.0, intercept = -1024.0;
  std::string series = "1.2.3.4";
  gdcm::TransferSyntax::TSType syntax = gdcm::TransferSyntax::ExplicitVRLittleEndian;
  // Function that returns the value at a position, before the value is stored as (value - intercept) / slope.
  std::function<double(const Vec3&)> value = [](const Vec3& p) { return std::round(100 * p.x() + 10 * p.y() + p.z()); };

  Vec3 position(int x, int y) const { return origin + spacing * x * across + downSpacing.value_or(spacing) * y * down; }
  std::vector<std::int16_t> stored() const {
    std::vector<std::int16_t> numbers;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        numbers.push_back(static_cast<std::int16_t>(std::lround((value(position(x, y)) - intercept) / slope)));
    return numbers;
  }
};

// Adds an element of text to a data set, or of a unique identifier.
inline void putText(gdcm::DataSet& data, const gdcm::Tag& tag, const gdcm::VR& vr, std::string text) {
  if (text.size() % 2 != 0) text += vr == gdcm::VR::UI ? '\0' : ' ';
  gdcm::DataElement one(tag);
  one.SetVR(vr);
  one.SetByteValue(text.data(), static_cast<std::uint32_t>(text.size()));
  data.Replace(one);
}

inline std::string dicomOf(const MadeSlice& slice) {
  gdcm::Trace::WarningOff();  // suppresses warnings about the values that are added later
  const std::vector<std::int16_t> stored = slice.stored();
  gdcm::ImageWriter writer;
  const gdcm::SmartPointer<gdcm::Image> held = new gdcm::Image;  // reference-counted
  gdcm::Image& image = *held;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, static_cast<unsigned>(slice.width));
  image.SetDimension(1, static_cast<unsigned>(slice.height));
  image.SetPixelFormat(gdcm::PixelFormat(gdcm::PixelFormat::INT16));
  image.SetPhotometricInterpretation(gdcm::PhotometricInterpretation(gdcm::PhotometricInterpretation::MONOCHROME2));
  image.SetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetByteValue(reinterpret_cast<const char*>(stored.data()), static_cast<std::uint32_t>(2 * stored.size()));
  image.SetDataElement(pixels);
  image.SetSpacing(0, slice.spacing);
  image.SetSpacing(1, slice.downSpacing.value_or(slice.spacing));
  for (unsigned k = 0; k < 3; ++k) image.SetOrigin(k, slice.origin[k]);
  // All six at once: GDCM replaces cosines that are not those of perpendicular axes.
  const Vec3 &a = slice.across, &d = slice.down;
  const double cosines[] = {a.x(), a.y(), a.z(), d.x(), d.y(), d.z()};
  image.SetDirectionCosines(cosines);
  image.SetSlope(slice.slope);
  image.SetIntercept(slice.intercept);
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(slice.syntax);
  change.SetInput(image);
  if (!change.Change()) return {};
  writer.SetImage(change.GetOutput());
  gdcm::DataSet& data = writer.GetFile().GetDataSet();
  putText(data, {0x0008, 0x0016}, gdcm::VR::UI, "1.2.840.10008.5.1.4.1.1.2");  // a CT
  putText(data, {0x0008, 0x0060}, gdcm::VR::CS, "CT");
  putText(data, {0x0010, 0x0010}, gdcm::VR::PN, "Mustermann^Erika");
  putText(data, {0x0020, 0x000e}, gdcm::VR::UI, slice.series);
  std::ostringstream stream;
  writer.SetStream(stream);
  return writer.Write() ? stream.str() : std::string();
}

}  // namespace handwheel::test
