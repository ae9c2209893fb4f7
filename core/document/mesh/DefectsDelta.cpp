// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/mesh/DefectsDelta.h"

#include <algorithm>
#include <iterator>

namespace handwheel {

namespace {

bool sameBox(const Box& a, const Box& b) {
  return a.min() == b.min() && a.max() == b.max();
}

// Compares all but the number, which follows from the position in the list.
bool sameLoop(const BoundaryLoop& a, const BoundaryLoop& b) {
  return a.halfEdges == b.halfEdges && a.borderEdges == b.borderEdges && a.length == b.length &&
         a.planarity == b.planarity && a.area == b.area && a.islands == b.islands &&
         a.isSheetBoundary == b.isSheetBoundary && a.centre == b.centre && sameBox(a.box, b.box);
}

bool sameComponent(const Component& a, const Component& b) {
  return a.faceCount == b.faceCount && a.area == b.area && a.volume == b.volume && a.debris == b.debris &&
         a.faces == b.faces;
}

template <class T>
std::size_t bytesOf(const std::vector<T>& list) {
  return list.capacity() * sizeof(T);
}

}  // namespace

template <class T, class Same>
DefectsDelta::Stretch<T> DefectsDelta::stretch(const std::vector<T>& before, const std::vector<T>& after, Same same) {
  Stretch<T> stretch;
  const auto [b, a] = std::mismatch(before.begin(), before.end(), after.begin(), after.end(), same);
  const auto tail = std::mismatch(before.rbegin(), std::make_reverse_iterator(b), after.rbegin(),
                                  std::make_reverse_iterator(a), same);
  stretch.begin = static_cast<std::size_t>(a - after.begin());
  stretch.behind = static_cast<std::size_t>(tail.second - after.rbegin());
  stretch.other.assign(a, tail.second.base());
  return stretch;
}

template <class T>
void DefectsDelta::swapStretch(std::vector<T>& list, Stretch<T>& stretch) {
  const auto first = list.begin() + static_cast<std::ptrdiff_t>(stretch.begin);
  const auto last = list.end() - static_cast<std::ptrdiff_t>(stretch.behind);
  std::vector<T> mine(std::make_move_iterator(first), std::make_move_iterator(last));
  list.insert(list.erase(first, last), std::make_move_iterator(stretch.other.begin()),
              std::make_move_iterator(stretch.other.end()));
  stretch.other = std::move(mine);
}

DefectsDelta DefectsDelta::between(const Defects& before, const Defects& after) {
  DefectsDelta delta;
  delta.m_loops = stretch(before.loops, after.loops, sameLoop);
  delta.m_nonManifoldEdges = stretch(before.nonManifoldEdges, after.nonManifoldEdges, std::equal_to<>());
  delta.m_nonManifoldVertices = stretch(before.nonManifoldVertices, after.nonManifoldVertices, std::equal_to<>());
  delta.m_nonOrientableEdges = stretch(before.nonOrientableEdges, after.nonOrientableEdges, std::equal_to<>());
  delta.m_inconsistentFaces = stretch(before.inconsistentFaces, after.inconsistentFaces, std::equal_to<>());
  delta.m_insideOut = stretch(before.insideOut, after.insideOut, std::equal_to<>());
  delta.m_degenerateFaces = stretch(before.degenerateFaces, after.degenerateFaces, std::equal_to<>());
  delta.m_duplicateFaces = stretch(before.duplicateFaces, after.duplicateFaces, std::equal_to<>());
  delta.m_nearVertices = stretch(before.nearVertices, after.nearVertices, std::equal_to<>());
  delta.m_components = stretch(before.components, after.components, sameComponent);
  delta.m_nestedBodies = after.nestedBodies;
  delta.m_box = after.box;
  return delta;
}

void DefectsDelta::swap(Defects& defects) {
  swapStretch(defects.loops, m_loops);
  for (std::size_t i = m_loops.begin; i < defects.loops.size(); ++i) defects.loops[i].id = static_cast<int>(i);
  swapStretch(defects.nonManifoldEdges, m_nonManifoldEdges);
  swapStretch(defects.nonManifoldVertices, m_nonManifoldVertices);
  swapStretch(defects.nonOrientableEdges, m_nonOrientableEdges);
  swapStretch(defects.inconsistentFaces, m_inconsistentFaces);
  swapStretch(defects.insideOut, m_insideOut);
  swapStretch(defects.degenerateFaces, m_degenerateFaces);
  swapStretch(defects.duplicateFaces, m_duplicateFaces);
  swapStretch(defects.nearVertices, m_nearVertices);
  swapStretch(defects.components, m_components);
  std::swap(defects.nestedBodies, m_nestedBodies);
  std::swap(defects.box, m_box);
}

std::size_t DefectsDelta::bytes() const {
  std::size_t bytes = sizeof *this + bytesOf(m_loops.other) + bytesOf(m_nonManifoldEdges.other) +
                      bytesOf(m_nonManifoldVertices.other) + bytesOf(m_nonOrientableEdges.other) +
                      bytesOf(m_inconsistentFaces.other) + bytesOf(m_degenerateFaces.other) +
                      bytesOf(m_duplicateFaces.other) + bytesOf(m_nearVertices.other) + bytesOf(m_components.other) +
                      bytesOf(m_insideOut.other);
  for (const BoundaryLoop& loop : m_loops.other) bytes += bytesOf(loop.halfEdges);
  for (const Component& component : m_components.other) bytes += bytesOf(component.faces);
  for (const std::vector<Face>& faces : m_insideOut.other) bytes += bytesOf(faces);
  return bytes;
}

}  // namespace handwheel
