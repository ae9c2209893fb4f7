// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Weld.h"

#include "mesh/structure/CancelPolling.h"

#include <bit>

namespace handwheel {
namespace {

std::uint32_t hash(const Vec3& p) {
  std::uint64_t h = 0;
  for (int k = 0; k < 3; ++k) {
    const double x = p[k] == 0.0 ? 0.0 : p[k];
    h = (h ^ std::bit_cast<std::uint64_t>(x)) * 0x9e3779b97f4a7c15ull;
    h ^= h >> 32;
  }
  return static_cast<std::uint32_t>(h);
}

// Open addressing at a load of at most one half. A slot keeps the hash beside the class, so that most misses are
// detected without reading the points, and the table grows with the classes, not with the points.
class SubmissionTable {
 public:
  explicit SubmissionTable(std::span<const Vec3> points) : m_points(points), m_slots(kSmallest) {}

  // The class of a point; representatives grows when it is a new one.
  std::uint32_t classify(std::uint32_t point, std::vector<std::uint32_t>& representatives) {
    const std::uint32_t h = hash(m_points[point]);
    for (std::size_t i = h & (m_slots.size() - 1);; i = (i + 1) & (m_slots.size() - 1)) {
      Slot& slot = m_slots[i];
      if (slot.klass == kNone) {
        const auto klass = static_cast<std::uint32_t>(representatives.size());
        slot = {klass, h};
        representatives.push_back(point);
        if (2 * representatives.size() > m_slots.size()) grow();
        return klass;
      }
      if (slot.hash == h && m_points[representatives[slot.klass]] == m_points[point]) return slot.klass;
    }
  }

 private:
  static constexpr std::size_t kSmallest = 1024;
  struct Slot {
    std::uint32_t klass = kNone;
    std::uint32_t hash = 0;
  };

  void grow() {
    std::vector<Slot> old(2 * m_slots.size());
    old.swap(m_slots);
    for (const Slot& slot : old) {
      if (slot.klass == kNone) continue;
      std::size_t i = slot.hash & (m_slots.size() - 1);
      while (m_slots[i].klass != kNone) i = (i + 1) & (m_slots.size() - 1);
      m_slots[i] = slot;
    }
  }

  std::span<const Vec3> m_points;
  std::vector<Slot> m_slots;
};

}  // namespace

PointClasses classifyPoints(std::span<const Vec3> points, Progress progress) {
  PointClasses result;
  result.classOf.resize(points.size());
  SubmissionTable table(points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!pollProgress(i, points.size(), progress)) break;
    result.classOf[i] = table.classify(static_cast<std::uint32_t>(i), result.representative);
  }
  return result;
}

TriangleSoup weld(const TriangleSoup& soup, Progress progress) {
  const PointClasses classes = classifyPoints(soup.points, progress.part(0.0, 0.7));
  if (progress.cancelled()) return {};
  std::vector<std::uint32_t> number(classes.representative.size(), kNone);
  TriangleSoup welded;
  welded.triangles.reserve(soup.triangles.size());
  for (const Triangle& t : soup.triangles) {
    if (!pollProgress(welded.triangles.size(), soup.triangles.size(), progress.part(0.7, 1.0))) return {};
    Triangle w;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t c = classes.classOf[t[k]];
      if (number[c] == kNone) {
        number[c] = static_cast<std::uint32_t>(welded.points.size());
        welded.points.push_back(soup.points[classes.representative[c]]);
      }
      w[k] = number[c];
    }
    welded.triangles.push_back(w);
  }
  return welded;
}

void roundPoints(TriangleSoup& soup, NumberType numbers) {
  for (Vec3& p : soup.points) p = rounded(p, numbers);
}

}  // namespace handwheel
