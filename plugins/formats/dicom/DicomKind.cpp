// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/DicomKind.h"

#include "dicom/DicomTags.h"

#include <gdcmReader.h>
#include <array>
#include <sstream>

namespace handwheel {

const char* reasonWithoutSlices(std::string_view file) {
  constexpr const char* kNoImage = "the file contains no image in grey";
  constexpr const char* kOther = "it holds a plan, a report or another object without an image";
  // Kinds of objects without pixels (PS3.4, B.5), by the beginning of their identifiers.
  struct Kind {
    std::string_view identifier;
    const char* reason;
  };
  constexpr std::array kKinds{
      Kind{"1.2.840.10008.5.1.4.1.1.481.3", "it holds contours of regions (an RT structure set), not an image"},
      Kind{"1.2.840.10008.5.1.4.1.1.481.5", kOther},
      Kind{"1.2.840.10008.5.1.4.1.1.481.8", kOther},
      Kind{"1.2.840.10008.5.1.4.1.1.66.5", kOther},
      Kind{"1.2.840.10008.5.1.4.1.1.66.1", kOther},
      Kind{"1.2.840.10008.5.1.4.1.1.66.3", kOther},
      Kind{"1.2.840.10008.5.1.4.1.1.11.", kOther},
      Kind{"1.2.840.10008.5.1.4.1.1.88.", kOther},
      Kind{"1.2.840.10008.5.1.4.1.1.104.", kOther},
  };
  std::istringstream stream{std::string(file)};
  gdcm::Reader reader;
  reader.SetStream(stream);
  if (!reader.ReadUpToTag(gdcm::Tag(0x7fe0, 0x0010))) return kNoImage;
  const gdcm::DataSet& data = reader.GetFile().GetDataSet();
  const std::string identifier = textAt(data, {0x0008, 0x0016});
  for (const Kind& kind : kKinds)
    if (identifier.starts_with(kind.identifier)) return kind.reason;
  if (countAt(data, {0x0028, 0x0002}).value_or(1) > 1) return "it holds a colour image, not one in grey";
  return kNoImage;
}

}  // namespace handwheel
