// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dicom/DicomTags.h"

#include "base/NumberText.h"

#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

const gdcm::ByteValue* valueAt(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  return data.FindDataElement(tag) ? data.GetDataElement(tag).GetByteValue() : nullptr;
}

std::string_view withoutPadding(std::string_view text) {
  constexpr std::string_view kPadding(" \0", 2);
  const std::size_t first = text.find_first_not_of(kPadding);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kPadding) - first + 1);
}

}  // namespace

std::string bytesAt(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  constexpr std::size_t kMost = 1 << 20;
  const gdcm::ByteValue* const value = valueAt(data, tag);
  if (!value || value->GetLength() > kMost) return {};
  return {value->GetPointer(), value->GetLength()};
}

std::string textAt(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  return std::string(withoutPadding(bytesAt(data, tag)));
}

std::vector<double> numbersAt(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  const std::string text = textAt(data, tag);
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\\', at), text.size());
    double number = 0.0;
    ErrorCode why;
    if (!parseDecimal(withoutPadding(std::string_view(text).substr(at, end - at)), number, why) ||
        !std::isfinite(number))
      return {};
    numbers.push_back(number);
    at = end + 1;
  }
  return numbers;
}

std::optional<double> numberAt(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  const std::vector<double> numbers = numbersAt(data, tag);
  return numbers.empty() ? std::optional<double>() : numbers.front();
}

std::optional<std::uint32_t> countAt(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  const gdcm::ByteValue* const value = valueAt(data, tag);
  if (!value) return {};
  const auto number = [&]<class Number>(Number one) {
    std::copy_n(value->GetPointer(), sizeof(Number), reinterpret_cast<char*>(&one));
    return std::uint32_t{one};
  };
  if (value->GetLength() == 2) return number(std::uint16_t{});
  if (value->GetLength() == 4) return number(std::uint32_t{});
  return {};
}

gdcm::SmartPointer<gdcm::SequenceOfItems> itemsAt(const gdcm::DataSet& data, const gdcm::Tag& tag) {
  if (!data.FindDataElement(tag)) return nullptr;
  const gdcm::SmartPointer<gdcm::SequenceOfItems> items = data.GetDataElement(tag).GetValueAsSQ();
  return items && items->GetNumberOfItems() > 0 ? items : nullptr;
}

std::optional<double> FrameTags::numberInStack(std::size_t frame) const {
  if (frame >= ownCount()) return {};
  const Items content = itemsAt(m_own->GetItem(frame + 1).GetNestedDataSet(), {0x0020, 0x9111});
  return content ? countAt(content->GetItem(1).GetNestedDataSet(), {0x0020, 0x9057}) : std::nullopt;
}

FrameTags::FrameTags(const gdcm::DataSet& file)
    : m_file(file), m_own(itemsAt(file, {0x5200, 0x9230})), m_shared(itemsAt(file, {0x5200, 0x9229})) {}

}  // namespace handwheel
