// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gdcmDataSet.h>
#include <gdcmSequenceOfItems.h>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// Returns the bytes of an element. They are empty if the element is missing, or is longer than a megabyte.
std::string bytesAt(const gdcm::DataSet& data, const gdcm::Tag& tag);
// Returns the text of an element without its padding.
std::string textAt(const gdcm::DataSet& data, const gdcm::Tag& tag);

// Returns the numbers of an element of the type DS or IS. The result is empty if one of them is not a finite number.
std::vector<double> numbersAt(const gdcm::DataSet& data, const gdcm::Tag& tag);
// Returns the first number of an element of the type DS or IS.
std::optional<double> numberAt(const gdcm::DataSet& data, const gdcm::Tag& tag);

// Returns the number of an element of the type US or UL.
std::optional<std::uint32_t> countAt(const gdcm::DataSet& data, const gdcm::Tag& tag);

// Returns the items of a sequence; null if there are none.
gdcm::SmartPointer<gdcm::SequenceOfItems> itemsAt(const gdcm::DataSet& data, const gdcm::Tag& tag);

// The values of a frame. They are in sequences of the frame itself, of all frames, or in the file (PS3.3, C.7.6.16).
class FrameTags {
  using Items = gdcm::SmartPointer<gdcm::SequenceOfItems>;

 public:
  // file: the values of the file. Sequences and items of the file must outlive this object.
  explicit FrameTags(const gdcm::DataSet& file);

  // Returns the number of frames with values of their own.
  std::size_t ownCount() const { return m_own ? m_own->GetNumberOfItems() : 0; }

  // Returns the position of a frame in its stack, if it is stated.
  std::optional<double> numberInStack(std::size_t frame) const;

  // Calls read with the sets of values that may contain an element of this sequence, the most specific one first, until
  // it returns a value. isOwn is true for a value of this frame alone.
  template <class Read>
  auto find(std::size_t frame, const gdcm::Tag& sequence, Read read) const -> decltype(read(gdcm::DataSet(), true)) {
    if (frame < ownCount())
      if (const Items own = itemsAt(m_own->GetItem(frame + 1).GetNestedDataSet(), sequence))
        if (auto value = read(own->GetItem(1).GetNestedDataSet(), true)) return value;
    if (m_shared)
      if (const Items shared = itemsAt(m_shared->GetItem(1).GetNestedDataSet(), sequence))
        if (auto value = read(shared->GetItem(1).GetNestedDataSet(), false)) return value;
    return read(m_file, false);
  }

 private:
  const gdcm::DataSet& m_file;
  Items m_own, m_shared;
};

}  // namespace handwheel
