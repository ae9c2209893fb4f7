// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrillingSubject.h"

#include "base/NumberText.h"
#include "document/FileBytes.h"
#include "document/container/UnknownPart.h"
#include "document/exercise/ExerciseErrors.h"
#include "document/exercise/ExerciseSnapshot.h"
#include "document/volume/VolumeBlobs.h"
#include "document/volume/VolumeMaking.h"
#include "document/volume/exercise/DescribedHoles.h"
#include "document/volume/exercise/DrillingDetails.h"
#include "document/volume/exercise/DrillingMeasurements.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeSampler.h"
#include "volume/drilling/Skull.h"
#include "volume/surface/VolumeToSurface.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

const DrillingTask& drillingOf(const ExerciseTask& task) {
  return static_cast<const DrillingTask&>(task);
}

const VolumeSnapshot& workOf(const Snapshot& work) {
  return static_cast<const VolumeSnapshot&>(work);
}

TaskPointer pointerTo(DrillingTask task) {
  return std::make_shared<const DrillingTask>(std::move(task));
}

const char* wordFor(const DrillBit& tool) {
  return tool.shape == DrillShape::Twist  ? QT_TRANSLATE_NOOP("Note", "Twist drill ⌀%1 mm, %2 r/min")
         : tool.shape == DrillShape::Burr ? QT_TRANSLATE_NOOP("Note", "Burr ⌀%1 mm, %2 r/min")
                                          : QT_TRANSLATE_NOOP("Note", "Ball head ⌀%1 mm, %2 r/min");
}

// A volume from a container or a file of images.
Result<SparseVolume> volumeIn(const std::filesystem::path& path, std::vector<Note>& notes, Progress progress) {
  if (!isContainerName(path)) {
    const auto imported = importVolume(path, notes, progress);
    return imported ? Result<SparseVolume>((*imported)->volume) : imported.error();
  }
  const Result<std::string> bytes = readFileBytes(path, progress.part(0.0, 0.3));
  if (!bytes) return bytes.error();
  const Result<ReadContainer> read = readContainer(*bytes, progress.part(0.3, 0.6));
  if (!read) return read.error();
  std::vector<Error> damage = read->damage;
  Result<SparseVolume> volume = readVolume(read->container, damage, progress.part(0.6, 1.0));
  if (volume && !damage.empty()) return damage.front();
  return volume;
}

// A rod around a line, of twelve sides.
TriangleSoup rod(const Vec3& from, const Vec3& to, double radius) {
  constexpr std::uint32_t kSides = 12;
  const Vec3 along = (to - from).normalized(), u = along.unitOrthogonal(), v = along.cross(u);
  TriangleSoup soup;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2.0 * M_PI * i / kSides;
    const Vec3 out = radius * (std::cos(angle) * u + std::sin(angle) * v);
    soup.points.push_back(from + out);
    soup.points.push_back(to + out);
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
    soup.triangles.push_back({a, b, b + 1});
    soup.triangles.push_back({a, b + 1, a + 1});
  }
  return soup;
}

TriangleSoup ball(const SolidBall& of) {
  constexpr std::uint32_t kRows = 24, kColumns = 48;
  TriangleSoup soup;
  for (std::uint32_t i = 0; i <= kRows; ++i)
    for (std::uint32_t k = 0; k < kColumns; ++k) {
      const double polar = M_PI * i / kRows, around = 2.0 * M_PI * k / kColumns;
      soup.points.push_back(of.centre + of.radius * Vec3(std::sin(polar) * std::cos(around),
                                                         std::sin(polar) * std::sin(around), std::cos(polar)));
      if (i == kRows) continue;
      const std::uint32_t next = (k + 1) % kColumns, row = i * kColumns, below = row + kColumns;
      if (i + 1 < kRows) soup.triangles.push_back({row + k, below + k, below + next});
      if (i > 0) soup.triangles.push_back({row + k, below + next, row + next});
    }
  return soup;
}

DisplayPart part(std::string name, TriangleSoup soup, std::array<float, 3> colour) {
  DisplayPart made;
  made.name = std::move(name);
  made.soup = std::make_shared<const TriangleSoup>(std::move(soup));
  made.colour = colour;
  return made;
}

}  // namespace

std::vector<DisplayPart> planParts(const DrillPlan& plan) {
  constexpr double kOutside = 60.0, kInside = 15.0;  // mm, of the rod
  std::vector<DisplayPart> parts;
  parts.push_back(part(
      "planned path",
      rod(plan.entry - kOutside * plan.direction, plan.entry + kInside * plan.direction, std::min(0.5, plan.tolerance)),
      {0.20f, 0.62f, 0.32f}));
  parts.back().isSectioned = false;
  for (std::size_t i = 0; i < plan.forbidden.size(); ++i)
    parts.push_back(part("forbidden " + std::to_string(i + 1), ball(plan.forbidden[i]), {0.86f, 0.52f, 0.54f}));
  return parts;
}

std::string DrillingSubject::title() const {
  return QT_TRANSLATE_NOOP("Figure", "Drilling");
}

std::vector<MeasurementType> DrillingSubject::figures() const {
  return drillingMeasurementTypes();
}

Status DrillingSubject::applyTolerance(MarkingCriterion& criterion) const {
  return Error{
      ErrorCode::ElementMalformed, {namedInErrors(criterion), "figures of drilling have limits, no tolerance"}, {}, {}};
}

TaskPointer DrillingSubject::blankTask() const {
  return pointerTo(DrillingTask::ofSkull());
}

nlohmann::json DrillingSubject::toJson(const ExerciseTask& task) const {
  return handwheel::toJson(drillingOf(task));
}

TaskPointer DrillingSubject::fromJson(const nlohmann::json& json, std::vector<Error>& damage) const {
  return pointerTo(drillingTaskFrom(json, damage));
}

nlohmann::json DrillingSubject::unknownKeys(const nlohmann::json& json, const ExerciseTask& task) const {
  return json.is_object() ? keysBeyond(json, toJson(task)) : nlohmann::json::object();
}

std::vector<Property> DrillingSubject::properties(const ExerciseTask& task) const {
  return propertiesOf(drillingOf(task));
}

Result<TaskPointer> DrillingSubject::withProperty(const ExerciseTask& task, const std::string& id,
                                                  const PropertyValue& value) const {
  Result<DrillingTask> changed = withTaskProperty(drillingOf(task), id, value);
  if (!changed) return changed.error();
  return pointerTo(std::move(*changed));
}

std::vector<ExerciseText> DrillingSubject::conditions(const ExerciseTask& task) const {
  const DrillingTask& drilling = drillingOf(task);
  const DrillMaterial& material = *drillMaterial(drilling.material);
  std::vector<ExerciseText> lines = {
      {wordFor(drilling.tool), {shownText(drilling.tool.diameter), shownText(drilling.spindle)}},
      {QT_TRANSLATE_NOOP("Note", "Material: %1"),
       {QCoreApplication::translate("Property", material.name.c_str()).toStdString()}},
      {QT_TRANSLATE_NOOP("Note", "Planned path within %1 mm: the green line"), {shownText(drilling.plan.tolerance)}}};
  if (!drilling.plan.forbidden.empty())
    lines.push_back({QT_TRANSLATE_NOOP("Note", "The head must not enter the forbidden region")});
  return lines;
}

SnapshotPointer DrillingSubject::start(const ExerciseTask& task) const {
  const DrillingTask& drilling = drillingOf(task);
  if (!drilling.stock) return skullContent();
  auto content = std::make_shared<VolumeSnapshot>();
  content->volume = drilling.volume();
  content->surface = VolumeSurface(content->volume);
  return content;
}

Status DrillingSubject::checkWork(const ExerciseTask& task, const Snapshot& work) const {
  const SparseVolume &wanted = drillingOf(task).volume(), &given = workOf(work).volume;
  if (wanted.voxel() == given.voxel() && wanted.origin() == given.origin()) return Done{};
  return Error{ExerciseError::OtherWork, {"its voxels are not those of the stock"}, {}, {}};
}

std::optional<std::size_t> DrillingSubject::triesOf(const Snapshot& work) const {
  return handwheel::triesOf(workOf(work)).count;
}

Result<SnapshotPointer> DrillingSubject::makeWork(const ExerciseTask& task, const nlohmann::json& description,
                                                  Progress progress) const {
  const DrillingTask& drilling = drillingOf(task);
  Result<DrilledHoles> holes = describedHoles(description, drilling);
  if (!holes) return holes.error();
  const auto drilled = reviewDrilling(drilling.volume(), drilling.plan, *holes, progress.part(0.0, 0.8));
  if (!drilled) return Error{ErrorCode::Cancelled, {}, {}, {}};
  auto work = std::make_shared<VolumeSnapshot>(workOf(*start(task)));
  std::vector<VoxelIndex> changed;
  drilling.volume().forEach([&](const VoxelIndex& block, const SparseVolume::Content& content) {
    if (drilled->left.content(block) != content) changed.push_back(block);
  });
  work->volume = drilled->left;
  work->surface.update(work->volume, changed);
  work->holes = std::move(*holes);
  return SnapshotPointer(std::move(work));
}

nlohmann::json DrillingSubject::describeWork(const ExerciseTask&, const Snapshot&) const {
  return {};
}

Result<TaskPointer> DrillingSubject::withTarget(const ExerciseTask& task, const Snapshot& work) const {
  DrillingTask changed = drillingOf(task);
  const DrilledHoles& holes = workOf(work).holes;
  for (auto hole = holes.rbegin(); hole != holes.rend(); ++hole) {
    if ((*hole)->setup.tool.shape == DrillShape::Saw) continue;  // its slot does not go along the axis
    const VolumeSampler sampler(changed.volume());
    const PagedArray<DrillPose>& poses = (*hole)->poses;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Vec3 axis = poses[i].direction(), tip = poses[i].position() - (*hole)->setup.tool.reach() * axis;
      if (!(sampler.depthAt(tip).depth > 0.0)) continue;
      changed.plan.entry = tip;
      changed.plan.direction = -axis;
      return pointerTo(std::move(changed));
    }
  }
  return Error{ExerciseError::NothingDrilled, {}, {}, {}};
}

std::vector<std::string> DrillingSubject::targetEndings() const {
  std::vector<std::string> endings = {std::string(kContainerEnding)};
  for (const FileFormat& format : m_kind.formats())
    if (format.reads) endings.insert(endings.end(), format.endings.begin(), format.endings.end());
  return endings;
}

Result<DrillingSubject::ImportedTask> DrillingSubject::withImportedTarget(const ExerciseTask& task,
                                                                          const std::filesystem::path& path,
                                                                          std::optional<double> facing,
                                                                          Progress progress) const {
  ImportedTask imported;
  if (facing)
    imported.notes.push_back({QT_TRANSLATE_NOOP("Note", "There is no facing allowance: a part is drilled as it is.")});
  const Result<SparseVolume> volume = volumeIn(path, imported.notes, progress.part(0.0, 0.6));
  if (!volume) {
    Error error = volume.error();
    if (error.subject.empty()) error.subject = path.string();
    return error;
  }
  if (const std::size_t bytes = stockBytes(*volume); bytes > kLargestStock)
    return Error{VolumeErrors::TooLargeToSave,
                 {roundedText(volume->voxel()), roundedText(static_cast<double>(bytes) / 1e6, 3),
                  roundedText(static_cast<double>(kLargestStock) / 1e6, 3)},
                 {},
                 {}};
  DrillingTask changed = drillingOf(task);
  changed.stock = std::make_shared<const DrillingStock>(stockOf(*volume));
  changed.stock->shown();  // on this thread: it is displayed right after the import
  imported.notes.push_back(
      {QT_TRANSLATE_NOOP("Note",
                         "The planned path and the forbidden region stay where they are. Adapt them to "
                         "this volume; a drilled hole can be taken as the path."),
       {}});
  imported.task = pointerTo(std::move(changed));
  return imported;
}

Result<TaskPointer> DrillingSubject::withTurnedTarget(const ExerciseTask&) const {
  return Error{ExerciseError::WithoutTarget, {}, {}, {}};
}

Result<DrillingSubject::RoundedTask> DrillingSubject::withRoundedTarget(const ExerciseTask&, double, double) const {
  return Error{ExerciseError::WithoutTarget, {}, {}, {}};
}

std::vector<Measurement> DrillingSubject::measure(const Exercise& exercise, const ExerciseTask& task,
                                                  const Snapshot& work, Progress progress) const {
  const MeasuredDrilling drilling(drillingOf(task), workOf(work), progress);
  std::vector<Measurement> figures;
  for (const MarkingCriterion& criterion : exercise.criteria)
    if (!measurementType(commonMeasurements(), criterion.figure)) figures.push_back(drilling.measure(criterion));
  return figures;
}

ReportDetails DrillingSubject::details(const ExerciseTask& task, const Snapshot& work, Progress progress) const {
  const DrillingTask& drilling = drillingOf(task);
  const DrilledHoles& holes = workOf(work).holes;
  const auto review = reviewDrilling(drilling.volume(), drilling.plan, holes, progress.part(0.0, 0.8));
  if (!review) return {};
  ReportDetails details = drillingDetails(drilling, holes, *review, progress.part(0.8, 1.0));
  addTries(details, handwheel::triesOf(workOf(work)));
  return details;
}

DisplayModel DrillingSubject::display(const ExerciseTask& task) const {
  const DrillingTask& drilling = drillingOf(task);
  DisplayModel model{planParts(drilling.plan)};
  constexpr double kCoarse = 1.5;  // mm, of voxels: four to the bone, and made in a tenth of a second
  static const auto skull = std::make_shared<const TriangleSoup>(surfaceOf(skullOfVoxels(kCoarse)));
  DisplayPart bone;
  bone.name = bone.group = "stock";
  bone.soup = drilling.stock ? drilling.stock->shown() : skull;
  bone.colour = {0.90f, 0.86f, 0.76f};
  model.parts.push_back(std::move(bone));
  return model;
}

Result<WrittenFile> DrillingSubject::exportDrawing(const Exercise&, const ExerciseTask&,
                                                   const std::filesystem::path& path, Progress) const {
  return Error{ExerciseError::WithoutTarget, {}, {}, path.string()};
}

}  // namespace handwheel
