// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "MadeDicom.h"

#include <gdcmItem.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmWriter.h>
#include <initializer_list>
#include <sstream>

namespace handwheel::test {

// An artificial image of several frames in one file, written by GDCM. All frames have the same size.
struct MadeFrames {
  std::vector<MadeSlice> frames;
  // The values of frames are in functional groups (PS3.3, C.7.6.16), or else those of the first frame in the file.
  bool hasGroups = true;
  bool hasPositions = true, hasOrientation = true, hasSpacing = true;
  bool isScaleShared = true;
  bool isOrientationShared = true;
  std::optional<double> between = {};                        // SpacingBetweenSlices, mm
  std::optional<double> thickness = {};                      // SliceThickness, mm
  std::vector<std::pair<gdcm::Tag, std::string>> more = {};  // further decimal strings of the file
};

namespace made_frames {

inline std::string textOf(std::initializer_list<double> numbers) {
  std::ostringstream text;
  text.precision(10);
  for (const double number : numbers) text << (text.tellp() > 0 ? "\\" : "") << number;
  return text.str();
}

inline void putNumbers(gdcm::DataSet& data, const gdcm::Tag& tag, std::initializer_list<double> numbers) {
  putText(data, tag, gdcm::VR::DS, textOf(numbers));
}

template <class Number>
void putCount(gdcm::DataSet& data, const gdcm::Tag& tag, const gdcm::VR& vr, Number number) {
  gdcm::DataElement one(tag);
  one.SetVR(vr);
  one.SetByteValue(reinterpret_cast<const char*>(&number), sizeof(number));
  data.Replace(one);
}

inline void putItems(gdcm::DataSet& data, const gdcm::Tag& tag, const std::vector<gdcm::DataSet>& sets) {
  const gdcm::SmartPointer<gdcm::SequenceOfItems> items = new gdcm::SequenceOfItems;  // reference-counted
  items->SetLengthToUndefined();
  for (const gdcm::DataSet& set : sets) {
    gdcm::Item item;
    item.SetVLToUndefined();
    item.SetNestedDataSet(set);
    items->AddItem(item);
  }
  gdcm::DataElement one(tag);
  one.SetVR(gdcm::VR::SQ);
  one.SetValue(*items);
  one.SetVLToUndefined();
  data.Replace(one);
}

inline void putPosition(gdcm::DataSet& data, const Vec3& p) {
  putNumbers(data, {0x0020, 0x0032}, {p.x(), p.y(), p.z()});
}
inline void putOrientation(gdcm::DataSet& data, const MadeSlice& slice) {
  const Vec3 &a = slice.across, &d = slice.down;
  putNumbers(data, {0x0020, 0x0037}, {a.x(), a.y(), a.z(), d.x(), d.y(), d.z()});
}
inline void putScale(gdcm::DataSet& data, const MadeSlice& slice) {
  putNumbers(data, {0x0028, 0x1052}, {slice.intercept});
  putNumbers(data, {0x0028, 0x1053}, {slice.slope});
}
inline void putMeasures(gdcm::DataSet& data, const MadeFrames& made) {
  const MadeSlice& first = made.frames.front();
  // The distance of rows comes first.
  if (made.hasSpacing) putNumbers(data, {0x0028, 0x0030}, {first.downSpacing.value_or(first.spacing), first.spacing});
  if (made.between) putNumbers(data, {0x0018, 0x0088}, {*made.between});
  if (made.thickness) putNumbers(data, {0x0018, 0x0050}, {*made.thickness});
}

inline void putGroups(gdcm::DataSet& data, const MadeFrames& made) {
  const auto within = [](gdcm::DataSet& group, const gdcm::Tag& tag, auto put) {
    gdcm::DataSet values;
    put(values);
    putItems(group, tag, {values});
  };
  gdcm::DataSet shared;
  within(shared, {0x0028, 0x9110}, [&](gdcm::DataSet& values) { putMeasures(values, made); });
  const auto orientation = [&](gdcm::DataSet& group, const MadeSlice& slice) {
    within(group, {0x0020, 0x9116}, [&](gdcm::DataSet& values) { putOrientation(values, slice); });
  };
  const auto scale = [&](gdcm::DataSet& group, const MadeSlice& slice) {
    within(group, {0x0028, 0x9145}, [&](gdcm::DataSet& values) { putScale(values, slice); });
  };
  if (made.hasOrientation && made.isOrientationShared) orientation(shared, made.frames.front());
  if (made.isScaleShared) scale(shared, made.frames.front());
  std::vector<gdcm::DataSet> own;
  for (const MadeSlice& frame : made.frames) {
    gdcm::DataSet group;
    if (made.hasPositions)
      within(group, {0x0020, 0x9113}, [&](gdcm::DataSet& values) { putPosition(values, frame.origin); });
    if (made.hasOrientation && !made.isOrientationShared) orientation(group, frame);
    if (!made.isScaleShared) scale(group, frame);
    own.push_back(group);
  }
  putItems(data, {0x5200, 0x9229}, {shared});
  putItems(data, {0x5200, 0x9230}, own);
}

}  // namespace made_frames

inline std::string dicomOf(const MadeFrames& made) {
  using namespace made_frames;
  gdcm::Trace::WarningOff();
  gdcm::Writer writer;
  gdcm::DataSet& data = writer.GetFile().GetDataSet();
  const MadeSlice& first = made.frames.front();
  // An enhanced CT, or a CT of one frame by its name, as some programs export several.
  putText(data, {0x0008, 0x0016}, gdcm::VR::UI,
          made.hasGroups ? "1.2.840.10008.5.1.4.1.1.2.1" : "1.2.840.10008.5.1.4.1.1.2");
  putText(data, {0x0008, 0x0018}, gdcm::VR::UI, "1.2.3.4.5.6");
  putText(data, {0x0008, 0x0060}, gdcm::VR::CS, "CT");
  putText(data, {0x0020, 0x000e}, gdcm::VR::UI, first.series);
  putText(data, {0x0028, 0x0004}, gdcm::VR::CS, "MONOCHROME2");
  putText(data, {0x0028, 0x0008}, gdcm::VR::IS, std::to_string(made.frames.size()));
  putCount(data, {0x0028, 0x0002}, gdcm::VR::US, std::uint16_t{1});
  putCount(data, {0x0028, 0x0010}, gdcm::VR::US, static_cast<std::uint16_t>(first.height));
  putCount(data, {0x0028, 0x0011}, gdcm::VR::US, static_cast<std::uint16_t>(first.width));
  putCount(data, {0x0028, 0x0100}, gdcm::VR::US, std::uint16_t{16});
  putCount(data, {0x0028, 0x0101}, gdcm::VR::US, std::uint16_t{16});
  putCount(data, {0x0028, 0x0102}, gdcm::VR::US, std::uint16_t{15});
  putCount(data, {0x0028, 0x0103}, gdcm::VR::US, std::uint16_t{1});
  if (made.hasGroups) {
    putGroups(data, made);
  } else {
    putMeasures(data, made);
    putScale(data, first);
    if (made.hasPositions) putPosition(data, first.origin);
    if (made.hasOrientation) putOrientation(data, first);
  }
  for (const auto& [tag, text] : made.more) putText(data, tag, gdcm::VR::DS, text);
  std::vector<std::int16_t> stored;
  for (const MadeSlice& frame : made.frames) {
    const std::vector<std::int16_t> own = frame.stored();
    stored.insert(stored.end(), own.begin(), own.end());
  }
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetVR(gdcm::VR::OW);
  pixels.SetByteValue(reinterpret_cast<const char*>(stored.data()), static_cast<std::uint32_t>(2 * stored.size()));
  data.Replace(pixels);
  writer.GetFile().GetHeader().SetDataSetTransferSyntax(gdcm::TransferSyntax::ExplicitVRLittleEndian);
  std::ostringstream stream;
  writer.SetStream(stream);
  return writer.Write() ? stream.str() : std::string();
}

}  // namespace handwheel::test
