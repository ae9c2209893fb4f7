// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/FaceSelection.h"

#include "mesh/structure/MeshBuilder.h"

namespace handwheel {

FaceSelection FaceSelection::all(const HalfEdgeMesh& mesh) {
  return where(mesh.faceSlots(), [&](Face f) { return mesh.isLive(f); });
}

FaceSelection FaceSelection::inverted(const HalfEdgeMesh& mesh) const {
  return where(mesh.faceSlots(), [&](Face f) { return !contains(f) && mesh.isLive(f); });
}

void FaceSelection::add(const FaceSelection& other) {
  forEachUnsharedWord(other, [&](std::size_t i) { setWord(i, word(i) | other.word(i)); });
}

void FaceSelection::remove(const FaceSelection& other) {
  if (&other == this) {
    *this = {};
    return;
  }
  for (std::size_t i = 0; i < std::min(m_words.size(), other.m_words.size()); ++i)
    setWord(i, m_words[i] & ~other.m_words[i]);
}

void FaceSelection::dropDead(const HalfEdgeMesh& mesh) {
  for (std::size_t i = 0; i < m_words.size(); ++i) {
    Word live = 0;
    forEachBit(i, m_words[i], [&](Face f) {
      if (f < mesh.faceSlots() && mesh.isLive(f)) live |= Word{1} << f % kBits;
    });
    setWord(i, live);
  }
}

std::vector<Face> FaceSelection::faces() const {
  std::vector<Face> result;
  result.reserve(m_count);
  forEach([&](Face f) { result.push_back(f); });
  return result;
}

std::vector<Face> FaceSelection::facesIn(Face first, Face count) const {
  assert(first % kBits == 0 && count % kBits == 0);
  std::vector<Face> result;
  const std::size_t end = std::min((std::size_t{first} + count) / kBits, m_words.size());
  for (std::size_t i = first / kBits; i < end; ++i) forEachBit(i, m_words[i], [&](Face f) { result.push_back(f); });
  return result;
}

std::vector<std::size_t> FaceSelection::differingRanges(const FaceSelection& other, Face count) const {
  assert(count > 0 && count % kBits == 0);
  std::vector<std::size_t> result;
  forEachUnsharedWord(other, [&](std::size_t i) {
    const std::size_t range = i / (count / kBits);
    if ((result.empty() || result.back() != range) && word(i) != other.word(i)) result.push_back(range);
  });
  return result;
}

bool FaceSelection::operator==(const FaceSelection& other) const {
  bool same = m_count == other.m_count;
  if (same) forEachUnsharedWord(other, [&](std::size_t i) { same = same && word(i) == other.word(i); });
  return same;
}

void FaceSelection::setWord(std::size_t i, Word value) {
  const Word before = word(i);
  if (value == before) return;  // keeps the page shared
  while (m_words.size() <= i) m_words.push_back(0);
  m_words.set(i, value);
  m_count += static_cast<std::size_t>(std::popcount(value));
  m_count -= static_cast<std::size_t>(std::popcount(before));
}

bool FaceSelection::set(Face f, bool isIn) {
  assert(f != kNone);
  const Word bit = Word{1} << f % kBits;
  const std::size_t before = m_count;
  setWord(f / kBits, isIn ? word(f / kBits) | bit : word(f / kBits) & ~bit);
  return m_count != before;
}

std::size_t removeFaces(HalfEdgeMesh& mesh, const FaceSelection& faces, Progress progress) {
  std::size_t removed = 0;
  faces.forEach([&](Face f) {
    if (f >= mesh.faceSlots() || !mesh.isLive(f)) return;
    mesh.removeFace(f);
    ++removed;
  });
  if (removed > 0) relink(mesh, progress);
  return removed;
}

}  // namespace handwheel
