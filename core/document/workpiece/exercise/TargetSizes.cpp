// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TargetSizes.h"

#include "base/NumberText.h"
#include "document/workpiece/exercise/DrawingTolerance.h"
#include "machining/target/ProfileFeatures.h"

#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kFeature = 1e-3;       // mm: what is a cylinder or a face
constexpr double kShortest = 0.5;       // mm, along the axis: shorter ones are broken edges
constexpr double kShortArc = 1.0;       // mm: its radius is measured from five samples and more
constexpr double kMargin = 0.1;         // of the length: so far from the ends of a surface it is measured,
constexpr double kLargestMargin = 1.0;  // mm, at most
constexpr double kBeside = 1e-4;        // mm, above and below a face

struct GeneralTolerance {
  double upTo, deviation;
};

// ISO 2768-1, class m (medium). Table 1: sizes; mm.
constexpr GeneralTolerance kLengthLimits[] = {{6, 0.1},    {30, 0.2},   {120, 0.3}, {400, 0.5},
                                              {1000, 0.8}, {2000, 1.2}, {4000, 2.0}};
// Table 2: radii and heights of chamfers; mm.
constexpr GeneralTolerance kRadiusLimits[] = {{3, 0.2}, {6, 0.5}, {4000, 1.0}};
// Table 3: angles, by the length of the shorter side (mm); degrees.
constexpr GeneralTolerance kAngleLimits[] = {
    {10, 1.0}, {50, 0.5}, {120, 1.0 / 3.0}, {400, 1.0 / 6.0}, {4000, 1.0 / 12.0}};

template <std::size_t N>
double deviationOf(const GeneralTolerance (&table)[N], double size) {
  for (const GeneralTolerance& limit : table)
    if (size <= limit.upTo) return limit.deviation;
  return table[N - 1].deviation;
}

class TargetSizes {
 public:
  explicit TargetSizes(const TurningTask& task) : m_task(task), m_target(*task.target) {}

  std::vector<MarkingCriterion> find() {
    const std::vector<ProfileFeature> features = featuresOf(m_target, kFeature);
    for (const ProfileFeature& feature : features) {
      if (feature.kind == ProfileFeature::Kind::FlatFace && isTop(feature)) m_top = feature;
    }
    for (const ProfileFeature& feature : features) {
      if (feature.kind == ProfileFeature::Kind::FlatFace)
        addFace(feature);
      else
        addSurface(feature);
    }
    return std::move(m_found);
  }

 private:
  bool isTop(const ProfileFeature& face) const { return m_target.upperEnd() - face.low.y() <= kFeature; }

  void addSurface(const ProfileFeature& f) {
    const double from = std::max(f.low.y(), m_task.lathe.chuckHeight);
    const double length = f.high.y() - from;
    if (length < kShortest) return;
    const double margin = std::min(kMargin * length, kLargestMargin);
    MarkingCriterion c;
    c.arguments = {from + margin, f.high.y() - margin};
    if (f.kind == ProfileFeature::Kind::Cylinder) {
      if (!f.isInner && std::abs(f.value - m_task.stock.diameter) <= kFeature) return;
      c.figure = f.isInner ? "bore" : "diameter";
      add(std::move(c), "⌀", f.value, deviationOf(kLengthLimits, f.value));
    } else if (f.kind == ProfileFeature::Kind::Arc && length >= kShortArc) {
      c.figure = f.isInner ? "bore_arc" : "arc";
      add(std::move(c), "R", f.value, deviationOf(kRadiusLimits, f.value));
    } else if (f.kind == ProfileFeature::Kind::Taper && !f.isInner) {
      c.figure = "taper";
      add(std::move(c), "∠", f.value * 180.0 / std::numbers::pi, deviationOf(kAngleLimits, (f.high - f.low).norm()));
    }
  }

  // The radius at which a face is measured lies on it alone: in its middle.
  void addFace(const ProfileFeature& face) {
    const double z = face.low.y();
    if (!m_top || isTop(face) || z - m_target.lowerEnd() <= kFeature || z < m_task.lathe.chuckHeight) return;
    const auto below = m_target.extentAt(z - kBeside), above = m_target.extentAt(z + kBeside);
    if (!below || !above) return;
    const double r = 0.5 * (face.low.x() + face.high.x());
    const bool isOutside = (below->outer > r) != (above->outer > r);
    const double top = 0.5 * (m_top->low.x() + m_top->high.x());
    MarkingCriterion c;
    c.figure = isOutside ? "length" : "depth";
    c.arguments = {r, z, top, m_target.upperEnd()};
    const double length = m_target.upperEnd() - z;
    add(std::move(c), {}, length, deviationOf(kLengthLimits, length));
  }

  void add(MarkingCriterion c, const std::string& sign, double value, double deviation) {
    c.nominal = std::round(1e6 * value) / 1e6;
    c.tolerance = "±" + roundedText(deviation, 3);
    if (!applyDrawingTolerance(c)) return;
    c.name = sign + roundedText(*c.nominal) + (c.figure == "taper" ? "°" : "");
    c.points = 1.0;
    m_found.push_back(std::move(c));
  }

  const TurningTask& m_task;
  const TargetProfile& m_target;
  std::optional<ProfileFeature> m_top;
  std::vector<MarkingCriterion> m_found;
};

}  // namespace

std::vector<MarkingCriterion> sizesOfTarget(const TurningTask& task) {
  return task.target ? TargetSizes(task).find() : std::vector<MarkingCriterion>();
}

}  // namespace handwheel
