// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/NiftiLabels.h"

#include "base/ByteOrder.h"
#include "base/NumberText.h"
#include "volume/image/ImageLabels.h"
#include "xml/Xml.h"

#include <algorithm>

namespace handwheel {
namespace {

void takeLabels(const XmlElement& element, std::vector<ImageLabel>& labels) {
  for (const XmlElement& child : element.children) {
    const std::string* const key = child.name == "Label" ? child.attribute("Key") : nullptr;
    double value = 0.0;
    ErrorCode why;
    if (key && parseDecimal(*key, value, why) && labels.size() < kMostLabels) labels.push_back({value, child.text});
    takeLabels(child, labels);
  }
}

}  // namespace

std::vector<ImageLabel> labelsInExtensions(std::string_view extensions, std::endian order) {
  constexpr std::size_t kFlags = 4, kHead = 8;  // bytes before all extensions, and of the size and code of each
  std::vector<ImageLabel> labels;
  if (extensions.size() < kFlags || extensions.front() == '\0') return labels;
  extensions.remove_prefix(kFlags);
  while (extensions.size() > kHead) {
    const auto size = loadNumber<std::int32_t>(extensions.data(), order);
    if (size <= static_cast<int>(kHead)) break;
    std::string_view content = extensions.substr(kHead, static_cast<std::size_t>(size) - kHead);
    extensions.remove_prefix(std::min(extensions.size(), static_cast<std::size_t>(size)));
    content = content.substr(0, std::min(content.find('\0'), content.size()));
    if (content.find("<LabelTable") == std::string_view::npos) continue;
    if (const Result<XmlElement> table = readXml(content, {})) takeLabels(*table, labels);
  }
  return labels;
}

}  // namespace handwheel
