// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/PagedArray.h"
#include "base/Progress.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <vector>

namespace handwheel {

// A set of faces of a mesh. It has one bit per face slot, in pages that copies share, so a copy is cheap; union,
// difference and comparison take O(slots / 64), less where pages are shared. Faces keep their numbers, so a selection
// outlives edits of the mesh; dropDead() removes the faces that an edit removed.
class FaceSelection {
 public:
  FaceSelection() = default;
  FaceSelection(std::initializer_list<Face> faces) {
    for (const Face f : faces) add(f);
  }
  explicit FaceSelection(std::span<const Face> faces) {
    for (const Face f : faces) add(f);
  }

  // Returns the faces below slotCount for which isIn(face) is true. O(slotCount).
  template <class Predicate>
  static FaceSelection where(std::size_t slotCount, Predicate isIn);
  // Returns all live faces.
  static FaceSelection all(const HalfEdgeMesh& mesh);
  // Returns the live faces that are not in the selection.
  FaceSelection inverted(const HalfEdgeMesh& mesh) const;

  std::size_t count() const { return m_count; }
  bool empty() const { return m_count == 0; }
  bool contains(Face f) const { return (word(f / kBits) >> f % kBits & 1) != 0; }

  // Return true if the selection changes. f must not be kNone.
  bool add(Face f) { return set(f, true); }
  bool remove(Face f) { return contains(f) && set(f, false); }
  void add(const FaceSelection& other);
  void remove(const FaceSelection& other);
  // Removes the faces that are no longer in the mesh. O(slots / 64 + count).
  void dropDead(const HalfEdgeMesh& mesh);

  // Calls visit(face) for each face, in ascending order.
  template <class Visit>
  void forEach(Visit visit) const {
    for (std::size_t i = 0; i < m_words.size(); ++i) forEachBit(i, m_words[i], visit);
  }
  std::vector<Face> faces() const;
  // Returns the selected faces with numbers from first to first + count - 1. Both arguments must be multiples of 64.
  std::vector<Face> facesIn(Face first, Face count) const;
  // Returns the ranges of `count` face numbers (a multiple of 64) in which the two selections differ, in ascending
  // order. A display of the selection must draw these again. Range i starts at the face i · count.
  std::vector<std::size_t> differingRanges(const FaceSelection& other, Face count) const;

  bool operator==(const FaceSelection& other) const;

 private:
  static constexpr std::size_t kBits = 64;
  using Word = std::uint64_t;

  Word word(std::size_t i) const { return i < m_words.size() ? m_words[i] : 0; }
  void setWord(std::size_t i, Word value);
  bool set(Face f, bool isIn);

  // Calls visit(i) for each word that may differ from that of the other selection.
  template <class Visit>
  void forEachUnsharedWord(const FaceSelection& other, Visit visit) const {
    constexpr std::size_t kPage = PagedArray<Word>::kPageSize;
    const std::size_t size = std::max(m_words.size(), other.m_words.size());
    for (std::size_t i = 0; i < size; i += kPage) {
      if (m_words.sharesPage(other.m_words, i / kPage)) continue;
      for (std::size_t k = i; k < std::min(i + kPage, size); ++k) visit(k);
    }
  }

  template <class Visit>
  static void forEachBit(std::size_t i, Word bits, Visit visit) {
    for (; bits != 0; bits &= bits - 1)
      visit(static_cast<Face>(kBits * i + static_cast<std::size_t>(std::countr_zero(bits))));
  }

  PagedArray<Word> m_words;
  std::size_t m_count = 0;
};

// Removes the selected live faces and relinks the mesh (relink()). Returns the number of removed faces. The mesh is
// invalid if cancelled. O(n).
std::size_t removeFaces(HalfEdgeMesh& mesh, const FaceSelection& faces, Progress progress = {});

template <class Predicate>
FaceSelection FaceSelection::where(std::size_t slotCount, Predicate isIn) {
  FaceSelection result;
  for (std::size_t first = 0; first < slotCount; first += kBits) {
    Word bits = 0;
    for (std::size_t k = 0; k < std::min(kBits, slotCount - first); ++k)
      bits |= static_cast<Word>(isIn(static_cast<Face>(first + k)) ? 1 : 0) << k;
    result.m_words.push_back(bits);
    result.m_count += static_cast<std::size_t>(std::popcount(bits));
  }
  return result;
}

}  // namespace handwheel
