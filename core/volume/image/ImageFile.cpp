// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageFile.h"

#include "base/ByteOrder.h"
#include "base/NumberText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

Status checkLayout(const ImageGrid& grid, const SampleLayout& layout) {
  if (const Status checked = checkGrid(grid); !checked) return checked;
  if (!std::isfinite(layout.slope) || !std::isfinite(layout.intercept) || layout.slope == 0.0)
    return Error{ErrorCode::ElementMalformed, {"slope", "it is not a scale factor"}, {}, {}};
  return Done{};
}

// Returns true if all numbers of a type are values of 16 bits.
bool isShort(const SampleLayout& layout) {
  return (layout.type == SampleType::Int8 || layout.type == SampleType::UInt8 || layout.type == SampleType::Int16) &&
         layout.slope == 1.0 && layout.intercept == 0.0;
}

template <class Number, class Value>
std::vector<Value> valuesIn(const SampleLayout& layout, std::string_view bytes, std::size_t count) {
  const std::size_t step = sizeof(Number) * layout.perSample;
  std::vector<Value> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto number = loadNumber<Number>(bytes.data() + i * step, layout.order);
    if constexpr (std::is_same_v<Value, std::int16_t>)
      values[i] = static_cast<Value>(number);  // NOLINT(bugprone-signed-char-misuse): a sample, not a character
    else
      values[i] = static_cast<Value>(layout.slope * static_cast<double>(number) + layout.intercept);
  }
  return values;
}

template <class Value>
std::vector<Value> valuesOfType(const SampleLayout& layout, std::string_view bytes, std::size_t count) {
  switch (layout.type) {
    case SampleType::Int8:
      return valuesIn<std::int8_t, Value>(layout, bytes, count);
    case SampleType::UInt8:
      return valuesIn<std::uint8_t, Value>(layout, bytes, count);
    case SampleType::Int16:
      return valuesIn<std::int16_t, Value>(layout, bytes, count);
    case SampleType::UInt16:
      return valuesIn<std::uint16_t, Value>(layout, bytes, count);
    case SampleType::Int32:
      return valuesIn<std::int32_t, Value>(layout, bytes, count);
    case SampleType::UInt32:
      return valuesIn<std::uint32_t, Value>(layout, bytes, count);
    case SampleType::Int64:
      return valuesIn<std::int64_t, Value>(layout, bytes, count);
    case SampleType::UInt64:
      return valuesIn<std::uint64_t, Value>(layout, bytes, count);
    case SampleType::Float32:
      return valuesIn<float, Value>(layout, bytes, count);
    case SampleType::Float64:
      return valuesIn<double, Value>(layout, bytes, count);
  }
  return {};
}

ImageFile finished(const ImageGrid& grid, std::vector<float> values, std::vector<ImageRemark> remarks) {
  float least = std::numeric_limits<float>::max();
  std::size_t odd = 0;
  for (const float v : values) {
    if (std::isfinite(v))
      least = std::min(least, v);
    else
      ++odd;
  }
  if (odd > 0) {
    if (odd == values.size()) least = 0.0f;
    std::replace_if(
        values.begin(), values.end(), [](float v) { return !std::isfinite(v); }, least);
    remarks.push_back({ImageRemark::Kind::NotNumbers, {static_cast<double>(odd)}});
  }
  if (areShort(values)) {
    std::vector<std::int16_t> whole(values.size());
    std::transform(values.begin(), values.end(), whole.begin(), [](float v) { return static_cast<std::int16_t>(v); });
    return {ImageVolume(grid, std::move(whole)), std::move(remarks)};
  }
  return {ImageVolume(grid, std::move(values)), std::move(remarks)};
}

std::vector<ImageRemark> remarksOn(const SampleLayout& layout) {
  if (layout.perSample < 2) return {};
  return {{ImageRemark::Kind::FirstOfSeveral, {static_cast<double>(layout.perSample)}}};
}

}  // namespace

std::size_t bytesOf(SampleType type) {
  switch (type) {
    case SampleType::Int8:
    case SampleType::UInt8:
      return 1;
    case SampleType::Int16:
    case SampleType::UInt16:
      return 2;
    case SampleType::Int32:
    case SampleType::UInt32:
    case SampleType::Float32:
      return 4;
    default:
      return 8;
  }
}

std::size_t bytesOf(const ImageGrid& grid, const SampleLayout& layout) {
  return grid.count() * bytesOf(layout.type) * layout.perSample;
}

Result<ImageFile> imageOfBytes(const ImageGrid& grid, const SampleLayout& layout, std::string_view bytes) {
  if (const Status checked = checkLayout(grid, layout); !checked) return checked.error();
  const std::size_t needed = bytesOf(grid, layout);
  if (bytes.size() < needed)
    return Error{
        ErrorCode::DataTruncated, {"bytes of samples", std::to_string(needed), std::to_string(bytes.size())}, {}, {}};
  if (isShort(layout))
    return ImageFile{ImageVolume(grid, valuesOfType<std::int16_t>(layout, bytes, grid.count())), remarksOn(layout)};
  return finished(grid, valuesOfType<float>(layout, bytes, grid.count()), remarksOn(layout));
}

Result<ImageFile> imageOfText(const ImageGrid& grid, const SampleLayout& layout, std::string_view text) {
  if (const Status checked = checkLayout(grid, layout); !checked) return checked.error();
  constexpr std::string_view kBlanks = " \t\r\n\f\v,";
  const std::size_t needed = grid.count() * layout.perSample;
  std::vector<float> values;
  std::size_t found = 0;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos && found < needed; ++found) {
    const std::size_t end = std::min(text.find_first_of(kBlanks, at), text.size());
    const std::string_view word = text.substr(at, end - at);
    double number = 0.0;
    ErrorCode why;
    if (!parseDecimal(word, number, why) && why == ErrorCode::NumberMalformed)
      return Error{why, {std::string(word.substr(0, 40))}, {}, {}};
    if (found % layout.perSample == 0) values.push_back(static_cast<float>(layout.slope * number + layout.intercept));
    at = text.find_first_not_of(kBlanks, end);
  }
  if (found < needed)
    return Error{ErrorCode::DataTruncated, {"samples", std::to_string(needed), std::to_string(found)}, {}, {}};
  return finished(grid, std::move(values), remarksOn(layout));
}

bool areShort(const std::vector<float>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](float v) { return v >= -32768.0f && v <= 32767.0f && v == std::trunc(v); });
}

ImageFile imageOfValues(const ImageGrid& grid, std::vector<float> values) {
  return finished(grid, std::move(values), {});
}

}  // namespace handwheel
