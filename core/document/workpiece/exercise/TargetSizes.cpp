// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/exercise/TargetSizes.h"

#include "base/NumberText.h"
#include "document/workpiece/exercise/DrawingTolerance.h"
#include "machining/target/ProfileFeatures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace handwheel {

namespace {

constexpr double kFeature = 1e-3;       // mm, least size of a cylinder or a face
constexpr double kShortest = 0.5;       // mm, along the axis: shorter ones are broken edges
constexpr double kShortArc = 1.0;       // mm: its radius is measured from five samples and more
constexpr double kMargin = 0.1;         // share of the length: margin at the ends of a surface that is not measured,
constexpr double kLargestMargin = 1.0;  // mm, at most
constexpr double kBeside = 1e-4;        // mm, above and below a face
constexpr double kShortestCurve = 3.0;  // mm: shorter ones are fillets of many lines
constexpr double kShortestCone = 3.0;   // mm: shorter tapers are chamfers, which have an angle alone
constexpr double kBesideCone = 2.0;     // mm: so far beyond its ends the ends of a taper are looked for
constexpr double kStraight = 4.0;  // by the pieces beside it: a cylinder of that length is one, also within a curve

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
    m_pieces = featuresOf(m_target, kFeature);
    const std::vector<ProfileFeature>& pieces = m_pieces;
    for (const ProfileFeature& feature : pieces) {
      if (feature.kind == ProfileFeature::Kind::FlatFace && isTop(feature)) m_top = feature;
    }
    // Each curve replaces the pieces between its ends.
    std::size_t piece = 0;
    for (const ProfileFeature& feature : withCurves(pieces)) {
      const std::size_t first = piece++;
      if (feature.kind == ProfileFeature::Kind::FlatFace) {
        addFace(feature);
      } else if (feature.kind == ProfileFeature::Kind::Curve) {
        while (!isLastPiece(feature, pieces[piece - 1])) ++piece;
        addCurve(feature, std::span(pieces).subspan(first, piece - first));
      } else {
        addSurface(feature);
      }
    }
    addForms();
    return std::move(m_found);
  }

 private:
  // Along the axis, with the largest radius there.
  struct Form {
    double from, to, radius;
  };

  static bool isLastPiece(const ProfileFeature& curve, const ProfileFeature& piece) {
    return curve.isInner ? piece.low == curve.low : piece.high == curve.high;
  }

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
      if (from == f.low.y() && length >= kShortestCone) addTaperSizes(f);
    }
  }

  // The diameters at its ends, where no cylinder beside it has them, and its length.
  void addTaperSizes(const ProfileFeature& taper) {
    const double length = taper.length(), margin = std::min(kMargin * length, kLargestMargin);
    for (const ProfilePoint& end : {taper.high, taper.low}) {
      const double diameter = 2.0 * end.x();
      if (diameter <= kShortest || isOfCylinder(end)) continue;
      MarkingCriterion c;
      c.figure = "taper_diameter";
      c.arguments = {taper.low.y() + margin, taper.high.y() - margin, end.y()};
      add(std::move(c), "⌀", diameter, deviationOf(kLengthLimits, diameter));
    }
    MarkingCriterion c;
    c.figure = "taper_length";
    c.arguments = {std::max(taper.low.y() - kBesideCone, m_task.lathe.chuckHeight),
                   std::min(taper.high.y() + kBesideCone, m_target.upperEnd())};
    add(std::move(c), {}, length, deviationOf(kLengthLimits, length));
  }

  bool isOfCylinder(const ProfilePoint& end) const {
    return std::any_of(m_pieces.begin(), m_pieces.end(), [&](const ProfileFeature& f) {
      return f.kind == ProfileFeature::Kind::Cylinder && !f.isInner && std::abs(f.value - 2.0 * end.x()) <= kFeature &&
             (std::abs(f.low.y() - end.y()) <= kFeature || std::abs(f.high.y() - end.y()) <= kFeature);
    });
  }

  // Adds the form of a curve, and the cylinders in it, such as the stem of a glass, which are longer than the lines of
  // a curve.
  void addCurve(const ProfileFeature& curve, std::span<const ProfileFeature> pieces) {
    double largest = 0.0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const ProfileFeature& f = pieces[i];
      largest = std::max({largest, f.low.x(), f.high.x()});
      if (f.kind != ProfileFeature::Kind::Cylinder || i == 0 || i + 1 == pieces.size()) continue;
      if (f.length() >= kStraight * std::max(pieces[i - 1].length(), pieces[i + 1].length())) addSurface(f);
    }
    const double from = std::max(curve.low.y(), m_task.lathe.chuckHeight);
    if (curve.high.y() - from >= kShortestCurve) m_forms.push_back({from, curve.high.y(), largest});
  }

  // The deviation of a form is measured outside and inside: overlapping curves are one. The surface may be off by half
  // of the general tolerance of its diameter.
  void addForms() {
    std::sort(m_forms.begin(), m_forms.end(), [](const Form& a, const Form& b) { return a.from < b.from; });
    for (std::size_t i = 0; i < m_forms.size();) {
      Form form = m_forms[i];
      for (++i; i < m_forms.size() && m_forms[i].from < form.to; ++i)
        form = {form.from, std::max(form.to, m_forms[i].to), std::max(form.radius, m_forms[i].radius)};
      const double margin = std::min(kMargin * (form.to - form.from), kLargestMargin);
      MarkingCriterion c;
      c.figure = "profile";
      c.arguments = {form.from + margin, form.to - margin};
      c.lower = 0.0;
      c.upper = 0.5 * deviationOf(kLengthLimits, 2.0 * form.radius);
      c.name = "⌒ ±" + roundedText(*c.upper, 3);
      c.points = 1.0;
      m_found.push_back(std::move(c));
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
  std::vector<ProfileFeature> m_pieces;
  std::vector<Form> m_forms;
  std::vector<MarkingCriterion> m_found;
};

}  // namespace

std::vector<MarkingCriterion> sizesOfTarget(const TurningTask& task) {
  return task.target ? TargetSizes(task).find() : std::vector<MarkingCriterion>();
}

}  // namespace handwheel
