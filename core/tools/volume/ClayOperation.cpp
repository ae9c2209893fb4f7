// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/volume/ClayOperation.h"

#include "base/NumberText.h"
#include "document/volume/LayerSteps.h"
#include "simulation/clay/ClaySimulation.h"
#include "tools/volume/ClayTool.h"
#include "tools/volume/VoxelizeOperations.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeMemory.h"

#include <QtGlobal>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr double kLeastVoxels = 1.5;   // least radius
constexpr double kRadiusShare = 0.05;  // initial radius, as a share of the volume's extent
constexpr double kMostSamples = 1e7;   // samples of a stroke, some hours at 1 kHz
constexpr double kMostRadii = 1e6;     // length of a stroke, in radii; a dab takes a millisecond or more
constexpr double kRadiiAtOnce = 50.0;  // length between two samples, or of a step, in radii; limits the list of dabs

// In the order of ClayAction.
constexpr std::array<const char*, 10> kActionNames = {
    QT_TRANSLATE_NOOP("Property", "Add"),     QT_TRANSLATE_NOOP("Property", "Carve"),
    QT_TRANSLATE_NOOP("Property", "Inflate"), QT_TRANSLATE_NOOP("Property", "Smooth"),
    QT_TRANSLATE_NOOP("Property", "Flatten"), QT_TRANSLATE_NOOP("Property", "Move"),
    QT_TRANSLATE_NOOP("Property", "Smudge"),  QT_TRANSLATE_NOOP("Property", "Attract"),
    QT_TRANSLATE_NOOP("Property", "Pinch"),   QT_TRANSLATE_NOOP("Property", "Mask"),
};
constexpr std::array<const char*, 10> kActionWords = {"add", "carve",  "inflate", "smooth", "flatten",
                                                      "tug", "smudge", "attract", "pinch",  "mask"};

Parameter clayNumber(const char* id, const char* label, double value, Limits limits, const char* meaning,
                     const char* word) {
  return {.property =
              {.id = id, .group = {}, .label = label, .value = value, .least = limits.least, .largest = limits.largest},
          .meaning = meaning,
          .word = word};
}

Parameter clayMirror(const char* id, const char* label, const char* meaning) {
  return {.property = {.id = id, .group = {}, .label = label, .value = false}, .meaning = meaning};
}

Operation makeClayOperation() {
  Parameter tool = {.property = {.id = "tool",
                                 .group = {},
                                 .label = QT_TRANSLATE_NOOP("Property", "Action"),
                                 .value = static_cast<double>(ClayAction::Carve),
                                 .choices = {kActionNames.begin(), kActionNames.end()}},
                    .meaning =
                        "add and carve: a ball of material along the stroke; inflate: the surface grows; tug: material "
                        "goes along; smudge: it is drawn out along the surface; attract, pinch: it comes nearer; mask: "
                        "it is protected from later strokes",
                    .word = "TOOL",
                    .words = {kActionWords.begin(), kActionWords.end()}};
  return {.id = "clay",
          .title = QT_TRANSLATE_NOOP("Tool", "Shape clay"),
          .meaning = "Sculpts along strokes of the hand",
          .parameters = {
              std::move(tool),
              lengthParameter("radius", QT_TRANSLATE_NOOP("Property", "Brush radius"),
                              "Radius of the tool; default: a twentieth of the largest extent"),
              clayNumber("strength", QT_TRANSLATE_NOOP("Property", "Strength"), ClayBrush().strength, {-1.0, 1.0},
                         "Share of what the tool can do at most; below 0 it does the opposite. Not of add, carve, tug",
                         "N"),
              clayNumber("falloff", QT_TRANSLATE_NOOP("Property", "Falloff"), ClayBrush().falloff, {0.0, 1.0},
                         "0: the same within the radius; 1: less and less towards it. Not of add, carve", "N"),
              clayMirror("mirror-x", QT_TRANSLATE_NOOP("Property", "Mirror across X"),
                         "Do the same on the other side of the part's middle, along x"),
              clayMirror("mirror-y", QT_TRANSLATE_NOOP("Property", "Mirror across Y"), "The same along y"),
              clayMirror("mirror-z", QT_TRANSLATE_NOOP("Property", "Mirror across Z"), "The same along z"),
              clayNumber("rate", QT_TRANSLATE_NOOP("Property", "Cycles a second"), 1000.0, {1.0, 1e5},
                         "Places of the hand per second between those of the strokes", "HZ")}};
}

double bytesOf(const ClayState& state) {
  return static_cast<double>(state.volume.bytes() + state.surface.bytes() + (state.mask ? state.mask->bytes() : 0));
}

std::shared_ptr<const ClayState> stateOf(const ClaySimulation& simulation) {
  return std::static_pointer_cast<const ClayState>(simulation.state());
}

// Runs a simulation along a stroke, and lets it finish each of its steps. It fails as VolumeGrowth does.
class LedStroke {
 public:
  LedStroke(ClaySimulation& simulation, double radius, VolumeGrowth& growth)
      : m_simulation(simulation), m_growth(growth), m_longest(kRadiiAtOnce * radius) {}

  Status add(const Vec3& position, double time) {
    const double distance = m_inputs.empty() ? 0.0 : (position - m_inputs.back().proxy).norm();
    if (!m_inputs.empty() && (time >= m_begin + kPeriod || m_distance + distance > m_longest))
      if (const Status stepped = step(); !stepped) return stepped;
    if (m_inputs.empty()) m_begin = time;
    m_distance += distance;
    SimulationInput input;
    input.tip.position = input.proxy = position;
    input.tip.time = time;
    input.gesture = 1;
    m_inputs.push_back(input);
    return Done{};
  }
  Status end() {
    SimulationInput input;
    input.gesture = 1;
    input.isEnd = true;
    m_inputs.push_back(input);
    return step();
  }

 private:
  static constexpr double kPeriod = 1.0 / ClayTool::kRate;  // s

  Status step() {
    m_simulation.step(kPeriod, m_inputs);
    m_simulation.finish();
    m_inputs.clear();
    m_distance = 0.0;
    if (const auto refusal = m_growth.refusalAt(bytesOf(*stateOf(m_simulation)))) return *refusal;
    return Done{};
  }

  ClaySimulation& m_simulation;
  VolumeGrowth& m_growth;
  double m_longest;                       // mm, largest length of a step
  std::vector<SimulationInput> m_inputs;  // inputs of the next step
  double m_begin = 0.0;                   // s, start of the step
  double m_distance = 0.0;                // mm, length of the step
};

// Returns the number of samples from one pose to the next, including the latter.
double samplesBetween(const HandPose& from, const HandPose& to, double radius, double rate) {
  const double byTime = (to.time - from.time) * rate, byDistance = (to.position - from.position).norm() / radius;
  return std::max(1.0, std::ceil(std::max(byTime, byDistance / kRadiiAtOnce)));
}

Status canBeLed(const std::vector<HandStroke>& strokes, double radius, double rate) {
  double seconds = 0.0, distance = 0.0;
  for (const HandStroke& stroke : strokes)
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      seconds += stroke[i].time - stroke[i - 1].time;
      distance += (stroke[i].position - stroke[i - 1].position).norm();
    }
  if (!(seconds * rate <= kMostSamples))
    return Error{VolumeErrors::PathTooLong, {roundedText(seconds), roundedText(kMostSamples / rate)}, {}, {}};
  if (!(distance <= kMostRadii * radius))
    return Error{VolumeErrors::StrokesTooLong,
                 {roundedText(distance), roundedText(radius), roundedText(kMostRadii * radius)},
                 {},
                 {}};
  return Done{};
}

// The volume that only one of two surfaces encloses, from the blocks of two volumes; mm³.
struct MaterialDifference {
  double added = 0.0, removed = 0.0;

  void addBlock(const SparseVolume& before, const SparseVolume& after, const VoxelIndex& block) {
    const SparseVolume::View old = before.view(block), now = after.view(block);
    if (old.block == now.block && old.isFull == now.isFull) return;
    const auto enclosed = [](const SparseVolume::View& view, std::size_t i) {
      return VolumeBlock::enclosed(view.block    ? view.block->depths[i]
                                   : view.isFull ? VolumeBlock::kFull
                                                 : VolumeBlock::kEmpty);
    };
    int more = 0, less = 0;  // below 2^22 for a block
    for (std::size_t i = 0; i < VolumeBlock::kCount; ++i) {
      const int change = enclosed(now, i) - enclosed(old, i);
      (change < 0 ? less : more) += std::abs(change);
    }
    const double unit = std::pow(after.voxel(), 3) / VolumeBlock::kUnit;
    added += unit * more;
    removed += unit * less;
  }
};

}  // namespace

const Operation& clayOperation() {
  static const Operation operation = makeClayOperation();
  return operation;
}

std::span<const char* const> clayActionNames() {
  return kActionNames;
}

Limits clayRadii(const SparseVolume& volume) {
  return {kLeastVoxels * volume.voxel(), ClayDab::kMostVoxels * volume.voxel()};
}

ClayBrush usualClayBrush(const VolumeSnapshot& part) {
  const Box box = part.surface.box();
  ClayBrush brush;
  brush.radius = clayRadii(part.volume).bring(box.isEmpty() ? 0.0 : kRadiusShare * box.sizes().maxCoeff());
  if (!box.isEmpty()) brush.mirror = box.center();
  return brush;
}

Result<ClayBrush> clayBrushOf(const OperationValues& values, const VolumeSnapshot& part) {
  ClayBrush brush = usualClayBrush(part);
  brush.action = static_cast<ClayAction>(values.whole("tool"));
  brush.strength = values.number("strength");
  brush.falloff = values.number("falloff");
  brush.isMirrored = {values.flag("mirror-x"), values.flag("mirror-y"), values.flag("mirror-z")};
  const std::optional<double> radius = values.given("radius");
  if (!radius) return brush;
  const Limits limits = clayRadii(part.volume);
  if (*radius < limits.least || *radius > limits.largest)
    return Error{VolumeErrors::ClayRadius,
                 {roundedText(*radius), roundedText(part.volume.voxel()), roundedText(limits.least),
                  roundedText(limits.largest)},
                 {},
                 {}};
  brush.radius = *radius;
  return brush;
}

Result<std::shared_ptr<const VolumeSnapshot>> withLayerOnTop(const std::shared_ptr<const VolumeSnapshot>& part,
                                                             const std::string& name) {
  const std::size_t count = part->layers ? part->layers->all().size() : 0;
  if (count > 0 && part->layers->all().back().name == name) return withLayerShare(*part, count - 1, 1.0, true).volume;
  for (std::size_t i = 0; i < count; ++i)
    if (part->layers->all()[i].name == name)
      return Error{VolumeErrors::LayerBelow, {name, part->layers->all().back().name}, {}, {}};
  if (count >= ClayLayers::kMostLayers)
    return Error{VolumeErrors::TooManyLayers, {std::to_string(ClayLayers::kMostLayers)}, {}, {}};
  return withNewLayer(*part, name).volume;
}

Result<Sculpted> sculptAlong(const std::shared_ptr<const VolumeSnapshot>& part, const ClayBrush& brush,
                             const std::vector<HandStroke>& strokes, double rate, Progress progress) {
  if (brush.action != ClayAction::Mask && !takesStrokes(*part))
    return Error{VolumeErrors::LayerTakesNone, {part->layers->all().back().name}, {}, {}};
  if (const Status can = canBeLed(strokes, brush.radius, rate); !can) return can.error();
  auto begin = std::make_shared<ClayState>();
  begin->volume = part->volume;
  begin->surface = part->surface;
  begin->mask = part->mask;
  std::shared_ptr<const ClayState> state = std::move(begin);
  const auto channel = std::make_shared<ClayChannel>();
  VolumeGrowth growth(part->volume.voxel(), bytesOf(*state));
  std::set<std::array<int, 3>> changed;
  Sculpted done;
  for (std::size_t s = 0; s < strokes.size(); ++s) {
    const HandStroke& stroke = strokes[s];
    if (stroke.empty()) continue;
    ClaySimulation simulation(state, brush, channel);
    LedStroke led(simulation, brush.radius, growth);
    Status isLed = led.add(stroke.front().position, stroke.front().time);
    for (std::size_t i = 1; i < stroke.size(); ++i) {
      const HandPose &from = stroke[i - 1], &to = stroke[i];
      const double count = samplesBetween(from, to, brush.radius, rate);
      for (double k = 1.0; k <= count; ++k) {
        if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
        const double share = k / count, gone = static_cast<double>(i) - 1.0 + share;
        isLed =
            led.add(from.position + share * (to.position - from.position), from.time + share * (to.time - from.time));
        if (!isLed) return isLed.error();
        progress.set((static_cast<double>(s) + gone / static_cast<double>(stroke.size() - 1)) /
                     static_cast<double>(strokes.size()));
      }
    }
    isLed = led.end();
    if (!isLed) return isLed.error();
    done.seconds += stroke.back().time - stroke.front().time;
    state = stateOf(simulation);
    changed.insert(simulation.changed().begin(), simulation.changed().end());
  }
  if (state->volume.isEmpty()) return Error{VolumeErrors::NothingLeft, {}, {}, {}};
  MaterialDifference difference;
  for (const auto& [x, y, z] : changed) difference.addBlock(part->volume, state->volume, {x, y, z});
  done.added = difference.added;
  done.removed = difference.removed;
  done.changedBlocks = changed.size();
  auto after = std::make_shared<VolumeSnapshot>(*part);
  after->volume = state->volume;
  after->surface = state->surface;
  after->mask = state->mask;
  if (brush.action != ClayAction::Mask) recordStroke(*part, *after);
  done.part = std::move(after);
  return done;
}

}  // namespace handwheel
