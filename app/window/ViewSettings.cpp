// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/ViewSettings.h"

#include "theme/Icons.h"
#include "window/ActionToolTip.h"
#include "window/OfferedAction.h"

#include <QSettings>
#include <algorithm>

namespace handwheel {

namespace {

constexpr int kAlongView = 3;
const auto kPerspectiveKey = QStringLiteral("view/perspective");
const auto kCubeKey = QStringLiteral("view/cube");
const char* const kClipGroup = QT_TRANSLATE_NOOP("Property", "Clipping plane");

Property choice(const char* id, const char* label, int value, std::vector<std::string> choices) {
  Property property;
  property.id = id;
  property.group = QT_TRANSLATE_NOOP("Property", "View");
  property.label = label;
  property.value = static_cast<double>(value);
  property.least = 0;
  property.largest = static_cast<double>(choices.size()) - 1;
  property.choices = std::move(choices);
  return property;
}

Property toggle(const char* id, const char* label, bool on) {
  Property property;
  property.id = id;
  property.group = kClipGroup;
  property.label = label;
  property.value = on;
  return property;
}

}  // namespace

ViewSettings::ViewSettings(PropertyList& list, Viewport& viewport, QObject* parent)
    : QObject(parent),
      m_list(list),
      m_viewport(viewport),
      m_clip(tr("&Clip the model"), this),
      m_half(tr("&Half section"), this),
      m_perspective(tr("Perspective inste&ad of parallel"), this),
      m_cube(tr("&View cube"), this) {
  makeClipAction();
  makeHalfSectionAction();
  makeViewActions();
  connect(&m_list, &PropertyList::edited, this, [this](const std::string& id, const PropertyValue& value, bool) {
    set(id, value);
    refresh();
  });
}

void ViewSettings::makeClipAction() {
  m_clip.setObjectName(QStringLiteral("clipModel"));
  m_clip.setIcon(icon(QStringLiteral("clip")));
  m_clip.setIconVisibleInMenu(false);  // the check mark stands there
  m_clip.setCheckable(true);
  m_clip.setShortcut(QKeySequence(Qt::Key_C));
  setActionToolTip(m_clip, tr("Clip the model by a plane to look inside; the panel “View” positions the plane"));
  connect(&m_clip, &QAction::toggled, this, [this](bool on) {
    if (!on) m_half.setChecked(false);
    clip();
    refresh();
  });
}

void ViewSettings::makeHalfSectionAction() {
  m_half.setObjectName(QStringLiteral("halfSection"));
  m_half.setCheckable(true);
  setSectionAxis(std::nullopt);
  m_half.setShortcut(QKeySequence(Qt::SHIFT | Qt::Key_C));
  setActionToolTip(m_half, tr("Cut the part through its axis, seen from here, to look into its bores"));
  connect(&m_half, &QAction::triggered, this, [this](bool on) {
    if (on) cutThroughAxis();
    m_clip.setChecked(on);
  });
}

// The plane faces the viewer as far as it can while the axis is in it.
void ViewSettings::cutThroughAxis() {
  const Vec3 along = m_sectionAxis->direction, towards = m_viewport.camera().towardsViewer();
  const Vec3 across = towards - along.dot(towards) * along;
  m_viewDirection = across.norm() > 1e-3 ? Vec3(across.normalized()) : Vec3(along.unitOrthogonal());
  m_axis = kAlongView;
  m_isFlipped = false;
  m_offset = m_viewDirection.dot(m_sectionAxis->origin);
  clip();
  refresh();
}

void ViewSettings::setSectionAxis(std::optional<Ray> axis) {
  m_sectionAxis = std::move(axis);
  offer(m_half, m_sectionAxis.has_value(), tr("Only turned parts have an axis."));
  if (!m_sectionAxis && m_half.isChecked()) m_clip.setChecked(false);
}

void ViewSettings::makeViewActions() {
  prepare(m_perspective, "perspective", nullptr, tr("What is farther away looks smaller"));
  prepare(m_cube, "viewCube", nullptr, tr("The cube in the corner that turns the view"));
  m_perspective.setShortcut(QKeySequence(Qt::Key_O));
  m_perspective.setCheckable(true);
  m_cube.setCheckable(true);
  const QSettings kept;
  m_perspective.setChecked(kept.value(kPerspectiveKey, m_viewport.projection() == Projection::Perspective).toBool());
  m_cube.setChecked(kept.value(kCubeKey, true).toBool());
  m_viewport.setViewCubeVisible(m_cube.isChecked());
  project();
  connect(&m_perspective, &QAction::toggled, this, [this](bool on) {
    QSettings().setValue(kPerspectiveKey, on);
    project();
    refresh();
  });
  connect(&m_cube, &QAction::toggled, this, [this](bool on) {
    QSettings().setValue(kCubeKey, on);
    m_viewport.setViewCubeVisible(on);
    refresh();
  });
}

// The camera of a document may have been left before the choice was made.
void ViewSettings::project() {
  const Projection chosen = m_perspective.isChecked() ? Projection::Perspective : Projection::Parallel;
  if (m_viewport.projection() != chosen) m_viewport.setProjection(chosen);
}

void ViewSettings::refresh() {
  std::vector<Property> all{
      choice("projection", QT_TRANSLATE_NOOP("Property", "Projection"), m_perspective.isChecked(),
             {QT_TRANSLATE_NOOP("Property", "Parallel"), QT_TRANSLATE_NOOP("Property", "Perspective")})};
  Property cube = toggle("view_cube", QT_TRANSLATE_NOOP("Property", "View cube"), m_cube.isChecked());
  cube.group = all[0].group;
  all.push_back(cube);
  all.push_back(toggle("clip", QT_TRANSLATE_NOOP("Property", "Clip the model"), m_clip.isChecked()));
  Property axis = choice("clip_axis", QT_TRANSLATE_NOOP("Property", "Normal"), m_axis,
                         {"X", "Y", "Z", QT_TRANSLATE_NOOP("Property", "View direction")});
  axis.group = kClipGroup;
  all.push_back(axis);
  all.push_back(toggle("clip_flip", QT_TRANSLATE_NOOP("Property", "Flip side"), m_isFlipped));
  const auto [least, largest] = range();
  Property offset;
  offset.id = "clip_offset";
  offset.group = kClipGroup;
  offset.label = QT_TRANSLATE_NOOP("Property", "Offset");
  offset.quantity = Quantity::Length;
  offset.continuous = true;
  offset.least = least;
  offset.largest = largest;
  offset.value = std::clamp(m_offset, least, largest);
  offset.editable = m_clip.isChecked();
  all.push_back(offset);
  for (Property figure : m_figures) {
    figure.group = kClipGroup;
    all.push_back(std::move(figure));
  }
  m_list.setProperties(all);
}

void ViewSettings::setLengthUnit(LengthUnit unit) {
  m_list.setLengthUnit(unit);
}

void ViewSettings::setSectionFigures(std::vector<Property> statistics) {
  m_figures = std::move(statistics);
  refresh();
}

void ViewSettings::followModel() {
  project();
  const auto [least, largest] = range();
  m_offset =
      m_half.isChecked() ? m_viewDirection.dot(m_sectionAxis->origin) : least + m_relativeOffset * (largest - least);
  clip();
  refresh();
}

Vec3 ViewSettings::axis() const {
  return m_axis == kAlongView ? m_viewDirection : Vec3(Vec3::Unit(m_axis));
}

std::pair<double, double> ViewSettings::range() const {
  return m_viewport.bounds().isEmpty() ? std::pair(0.0, 1.0) : clipOffsets(m_viewport.bounds(), axis());
}

void ViewSettings::set(const std::string& id, const PropertyValue& value) {
  if (id == "projection") {
    m_perspective.setChecked(std::get<double>(value) > 0.5);
  } else if (id == "view_cube") {
    m_cube.setChecked(std::get<bool>(value));
  } else if (id == "clip") {
    m_clip.setChecked(std::get<bool>(value));
  } else if (id == "clip_axis") {
    m_half.setChecked(false);  // the plane is the user's from now on
    m_axis = static_cast<int>(std::get<double>(value));
    m_viewDirection = m_viewport.camera().towardsViewer();
    followModel();
  } else if (id == "clip_flip") {
    m_isFlipped = std::get<bool>(value);
    clip();
  } else if (id == "clip_offset") {
    m_half.setChecked(false);
    m_offset = std::get<double>(value);
    const auto [least, largest] = range();
    m_relativeOffset = largest > least ? (m_offset - least) / (largest - least) : 0.5;
    clip();
  }
}

void ViewSettings::clip() {
  const ClipPlane plane{axis(), m_offset, m_clip.isChecked()};
  m_viewport.setClipPlane(m_isFlipped ? plane.flipped() : plane);
}

}  // namespace handwheel
