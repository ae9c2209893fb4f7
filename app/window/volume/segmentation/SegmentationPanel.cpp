// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/segmentation/SegmentationPanel.h"

#include "base/NumberText.h"
#include "controls/NumberField.h"
#include "process/SystemMemory.h"
#include "tools/ToolProperty.h"
#include "volume/VolumeMemory.h"
#include "volume/image/ImageLabels.h"
#include "volume/image/ImageToVolume.h"
#include "volume/segment/SegmentToVolume.h"
#include "window/volume/segmentation/HistogramView.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {

namespace {

constexpr double kNoEnd = std::numeric_limits<double>::infinity();
constexpr int kDebrisSteps = 100;
constexpr const char* kLeftAtLeft = "slices/leftAtLeft";
constexpr double kLeastRadius = 0.001;  // mm

NumberField* field(const QString& label, const char* name, Quantity quantity = Quantity::Number) {
  auto* const made = new NumberField;
  made->setObjectName(QString::fromLatin1(name));
  made->setQuantity(quantity, LengthUnit::Millimetre);
  made->setLabel(label);
  made->setMaximumWidth(92);
  return made;
}

QWidget* rowOf(std::initializer_list<QWidget*> widgets) {
  auto* const row = new QWidget;
  auto* const layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  for (QWidget* each : widgets) layout->addWidget(each);
  layout->addStretch();
  return row;
}

QGroupBox* groupOf(const QString& title, std::initializer_list<QWidget*> rows) {
  auto* const group = new QGroupBox(title);
  auto* const layout = new QVBoxLayout(group);
  layout->setContentsMargins(8, 4, 8, 6);
  layout->setSpacing(4);
  for (QWidget* row : rows) layout->addWidget(row);
  return group;
}

QLabel* textLabel(const char* name) {
  auto* const label = new QLabel;
  label->setObjectName(QString::fromLatin1(name));
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  // Two lines are kept free, so that nothing moves while figures change.
  label->setMinimumHeight(2 * label->fontMetrics().lineSpacing());
  label->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  return label;
}

QPushButton* button(const QString& text, const char* name, const QString& tip) {
  auto* const made = new QPushButton(text);
  made->setObjectName(QString::fromLatin1(name));
  made->setToolTip(tip);
  return made;
}

QString number(double value, int digits = 4) {
  // No exponents: a head has a million mm³.
  return std::abs(value) < 1e4 ? QLocale().toString(value, 'g', digits) : QLocale().toString(value, 'f', 0);
}

double leastRadius(const ImageGrid& grid) {
  return std::min(kLeastRadius, 0.5 * grid.spacing().minCoeff());
}

// A ball of more samples would not follow the mouse.
double largestRadius(const ImageGrid& grid) {
  constexpr double kMostAcross = 200.0;
  return 0.5 * kMostAcross * grid.spacing().minCoeff();
}

// From a tenth of a sample, which adds nothing any more, to an eighth of the scan, which leaves little of it.
Limits voxelLimits(const ImageGrid& grid) {
  const double usual = usualVoxel(grid);
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    longest = std::max(longest, grid.spacing()[axis] * grid.size[static_cast<std::size_t>(axis)]);
  return {0.1 * usual, std::max(usual, 0.125 * longest)};
}

}  // namespace

SegmentationPanel::SegmentationPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("segmentationPanel"));
  auto* const column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 8);
  column->setSpacing(6);
  for (QWidget* group : {makeRange(), makeParts(), makeActions(), makeSurface(), makeGreys()}) column->addWidget(group);
  column->addStretch();
}

QWidget* SegmentationPanel::makeRange() {
  m_histogram = new HistogramView;
  m_lower = field(tr("Lower end of the range"), "segmentLower");
  m_upper = field(tr("Upper end of the range"), "segmentUpper");
  m_painted = textLabel("segmentPainted");
  connect(m_histogram, &HistogramView::rangeEdited, this, &SegmentationPanel::take);
  connect(m_lower, &NumberField::valueEdited, this, [this](double value, bool stillDragging) {
    take({value, std::max(value, m_upper->value())}, stillDragging);
  });
  connect(m_upper, &NumberField::valueEdited, this, [this](double value, bool stillDragging) {
    take({std::min(value, m_lower->value()), value}, stillDragging);
  });
  m_otsu = button(tr("&Otsu"), "segmentOtsu",
                  tr("From Otsu's threshold upwards, which best separates the values into two classes"));
  auto* const bone = button(tr("&Bone"), "segmentBone", tr("300 Hounsfield units and above"));
  auto* const skin = button(tr("&Skin"), "segmentSkin", tr("-200 Hounsfield units and above: everything except air"));
  connect(m_otsu, &QPushButton::clicked, this, [this] {
    if (m_scan) take({otsuThreshold(m_scan->histogram), kNoEnd}, false);
  });
  connect(bone, &QPushButton::clicked, this, [this] { take({300.0, kNoEnd}, false); });
  connect(skin, &QPushButton::clicked, this, [this] { take({-200.0, kNoEnd}, false); });
  m_presets = {bone, skin};
  m_labels = new QComboBox;
  m_labels->setObjectName(QStringLiteral("segmentLabels"));
  m_labels->setAccessibleName(tr("Label"));
  m_labels->setToolTip(tr("The region of the image that is taken"));
  connect(m_labels, &QComboBox::activated, this, [this](int index) {
    if (!m_scan || index < 0) return;
    const double label = m_labels->itemData(index).toDouble();
    take(index == 0 ? rangeOfLabels(m_scan->image) : ValueRange{label, label}, false);
  });
  return groupOf(tr("Values"), {m_histogram, rowOf({m_lower, new QLabel(tr("to")), m_upper}), m_labels,
                                rowOf({m_otsu, bone, skin}), m_painted});
}

QWidget* SegmentationPanel::makeParts() {
  m_parts = textLabel("segmentParts");
  auto* const largest = button(tr("&Largest part only"), "segmentLargest", tr("Keeps only the largest connected part"));
  m_keep = new QSpinBox;
  m_keep->setObjectName(QStringLiteral("segmentKeep"));
  m_keep->setAccessibleName(tr("Number of largest parts to keep"));
  m_keep->setRange(1, 1'000'000);
  m_keep->setValue(2);
  auto* const keep = button(tr("&Keep so many"), "segmentKeepParts", tr("Keeps this number of the largest parts"));
  m_debris = new QSlider(Qt::Horizontal);
  m_debris->setObjectName(QStringLiteral("segmentDebris"));
  m_debris->setAccessibleName(tr("Volume below which parts are debris"));
  m_debris->setRange(0, kDebrisSteps);
  m_debrisText = textLabel("segmentDebrisText");
  auto* const remove = button(tr("&Remove debris"), "segmentRemoveDebris", tr("Removes all parts smaller than this"));
  auto* const smooth =
      button(tr("S&mooth"), "segmentSmooth",
             tr("Removes specks and smooths steps: each sample follows the majority of its 3 × 3 × 3 neighbourhood"));
  connect(largest, &QPushButton::clicked, this, [this] { emit firstPartsKept(1); });
  connect(keep, &QPushButton::clicked, this, [this] { emit firstPartsKept(m_keep->value()); });
  connect(m_debris, &QSlider::valueChanged, this, &SegmentationPanel::showDebris);
  connect(remove, &QPushButton::clicked, this, [this] {
    if (m_figures.parts) emit firstPartsKept(static_cast<int>(m_figures.parts->countFrom(debrisLimit())));
  });
  connect(smooth, &QPushButton::clicked, this, &SegmentationPanel::smoothingRequested);
  m_ofParts = {largest, keep, remove};
  auto* const debris = rowOf({m_debris, remove});
  static_cast<QHBoxLayout*>(debris->layout())->setStretch(0, 1);
  return groupOf(tr("Parts"), {m_parts, rowOf({largest, smooth}), rowOf({m_keep, keep}), debris, m_debrisText});
}

QWidget* SegmentationPanel::makeActions() {
  m_actions = new QButtonGroup(this);
  const auto action = [&](SliceAction what, const QString& text, const char* name, const QString& tip) {
    QPushButton* const made = button(text, name, tip);
    made->setCheckable(true);
    made->setChecked(what == SliceAction::Look);
    m_actions->addButton(made, static_cast<int>(what));
    return made;
  };
  QWidget* const look = action(SliceAction::Look, tr("Cross&hair"), "segmentLook", tr("Click to move the crosshair"));
  QWidget* const paint = action(SliceAction::Paint, tr("&Paint"), "segmentPaint",
                                tr("Adds to the segment; Ctrl: erases. [ and ]: radius"));
  QWidget* const erase = action(SliceAction::Erase, tr("&Erase"), "segmentErase",
                                tr("Erases from the segment; Ctrl: adds. [ and ]: radius"));
  QWidget* const grow = action(SliceAction::Grow, tr("&Grow from point"), "segmentGrow",
                               tr("Click a point of the segment: only the part connected to it is kept"));
  m_radius = field(tr("Radius of the brush"), "segmentRadius", Quantity::Length);
  m_isBall = new QCheckBox(tr("Ball (&3D)"));
  m_isBall->setObjectName(QStringLiteral("segmentBall"));
  m_isBall->setToolTip(
      tr("The brush is a ball that reaches into neighbouring slices; otherwise it paints in one slice"));
  m_position = textLabel("segmentPlace");
  connect(m_actions, &QButtonGroup::idClicked, this, &SegmentationPanel::brushChanged);
  connect(m_radius, &NumberField::valueEdited, this, &SegmentationPanel::brushChanged);
  connect(m_isBall, &QCheckBox::toggled, this, &SegmentationPanel::brushChanged);
  return groupOf(tr("In the slices"), {rowOf({look, paint, erase}), rowOf({grow}),
                                       rowOf({new QLabel(tr("Radius")), m_radius, m_isBall}), m_position});
}

QWidget* SegmentationPanel::makeGreys() {
  m_level = field(tr("Level of the greys"), "segmentLevel");
  m_width = field(tr("Width of the greys"), "segmentWidth");
  m_width->setRange(1e-9, 1e9);
  const auto send = [this] { emit greysEdited({m_level->value(), m_width->value()}); };
  connect(m_level, &NumberField::valueEdited, this, send);
  connect(m_width, &NumberField::valueEdited, this, send);
  m_isLeftAtLeft = new QCheckBox(tr("Patient's left at the le&ft"));
  m_isLeftAtLeft->setObjectName(QStringLiteral("segmentLeftAtLeft"));
  m_isLeftAtLeft->setToolTip(
      tr("Shows slices as seen from the head and from the back; otherwise the patient's right is at the left, as "
         "radiologists have it"));
  m_isLeftAtLeft->setChecked(QSettings().value(kLeftAtLeft, false).toBool());
  connect(m_isLeftAtLeft, &QCheckBox::toggled, this, [this](bool isLeftAtLeft) {
    QSettings().setValue(kLeftAtLeft, isLeftAtLeft);
    emit sidesChanged(isLeftAtLeft);
  });
  return groupOf(tr("Greys"),
                 {rowOf({new QLabel(tr("Level")), m_level, new QLabel(tr("Width")), m_width}), m_isLeftAtLeft});
}

QWidget* SegmentationPanel::makeSurface() {
  m_voxel = field(tr("Edge of a voxel"), "segmentVoxel", Quantity::Length);
  m_isSmoothed = new QCheckBox(tr("Smooth &it"));
  m_isSmoothed->setObjectName(QStringLiteral("segmentSmoothSurface"));
  m_isSmoothed->setToolTip(tr("Smooths the voxel steps of the surface"));
  m_memory = textLabel("segmentMemory");
  m_make = button(
      tr("Make s&urface"), "segmentMakeSurface",
      tr("Creates the volume of the segment, which can be shaped, drilled and saved; undo restores the previous one"));
  m_make->setDefault(true);
  connect(m_voxel, &NumberField::valueEdited, this, &SegmentationPanel::showMemory);
  connect(m_make, &QPushButton::clicked, this, &SegmentationPanel::surfaceRequested);
  m_older = textLabel("segmentOlder");
  m_older->setText(tr("The volume was made from an earlier segment."));
  m_older->hide();
  return groupOf(tr("Surface"),
                 {rowOf({new QLabel(tr("Voxel")), m_voxel}), m_isSmoothed, m_memory, m_older, rowOf({m_make})});
}

void SegmentationPanel::setScan(const std::shared_ptr<const Scan>& scan) {
  m_scan = scan;
  m_figures = {};
  if (!scan) return;
  m_histogram->setHistogram(scan->histogram);
  const bool isCt = looksLikeHounsfield(scan->histogram.values);
  for (QPushButton* preset : m_presets) preset->setVisible(isCt);
  fillLabels();
  const double step = scan->image.isWhole() ? 1.0 : 0.0;
  for (NumberField* each : {m_lower, m_upper}) {
    each->setRange(scan->histogram.values.least, scan->histogram.values.largest);
    each->setStep(step);
  }
  const Limits voxels = voxelLimits(scan->image.grid());
  m_voxel->setRange(voxels.least, voxels.largest);
  m_voxel->setValue(usualVoxel(scan->image.grid()));
  // About a dozen samples across.
  m_radius->setRange(leastRadius(scan->image.grid()), largestRadius(scan->image.grid()));
  m_radius->setValue(roundedNumber(6.0 * usualVoxel(scan->image.grid()), 2));
  m_debris->setValue(0);
}

void SegmentationPanel::setSegment(const Segment& segment) {
  m_segment = segment;
  showRange(segment.range());
  m_painted->setText(segment.isByRangeAlone()
                         ? QString()
                         : tr("Edited by hand: choosing another range discards these edits (undo restores them)."));
  m_painted->setVisible(!segment.isByRangeAlone());
  setFigures({});
}

void SegmentationPanel::setFigures(const SegmentStatistics& figures) {
  m_figures = figures;
  const bool isKnown = m_scan && figures.parts;
  for (QPushButton* each : m_ofParts) each->setEnabled(isKnown && !figures.parts->samples().empty());
  if (isKnown) {
    const std::size_t total = figures.parts->total();
    const double volume = static_cast<double>(total) * std::abs(m_scan->image.grid().steps.determinant());
    m_parts->setText(total == 0 ? tr("No sample has a value in this range.")
                                : tr("%n part(s), %1 mm³; the largest is %2 % of it", nullptr,
                                     static_cast<int>(figures.parts->samples().size()))
                                      .arg(number(volume, 6))
                                      .arg(number(100.0 * static_cast<double>(figures.parts->samples().front()) /
                                                  static_cast<double>(total))));
  } else {
    m_parts->setText(tr("Counting parts…"));
  }
  m_make->setEnabled(isKnown && figures.parts->total() > 0);
  showDebris();
  showMemory();
}

void SegmentationPanel::setUncounted() {
  m_parts->setText(QString());
  m_make->setEnabled(m_scan != nullptr);
}

void SegmentationPanel::setOlder(bool isOlder) {
  m_older->setVisible(isOlder);
}

void SegmentationPanel::setGreys(const GreyWindow& greys) {
  m_level->setValue(greys.level);
  m_width->setValue(greys.width);
}

void SegmentationPanel::setPosition(const Vec3& index) {
  if (!m_scan) return;
  const ImageVolume& image = m_scan->image;
  const std::array<int, 3>& size = image.grid().size;
  const VoxelIndex at = index.array().round().matrix().cast<int>();
  const auto sample =
      (static_cast<std::size_t>(at.z()) * static_cast<std::size_t>(size[1]) + static_cast<std::size_t>(at.y())) *
          static_cast<std::size_t>(size[0]) +
      static_cast<std::size_t>(at.x());
  const Vec3 position = image.grid().position(at.cast<double>());
  const auto mm = [](double value) { return QLocale().toString(value, 'f', 1); };
  m_position->setText(tr("Value %1 at x %2, y %3, z %4 mm")
                          .arg(number(image.value(sample), 6), mm(position.x()), mm(position.y()), mm(position.z())));
}

bool SegmentationPanel::isLeftAtLeft() const {
  return m_isLeftAtLeft->isChecked();
}

SegmentationPanel::Brush SegmentationPanel::brush() const {
  return {static_cast<SliceAction>(m_actions->checkedId()), m_radius->value(), m_isBall->isChecked()};
}

void SegmentationPanel::stepRadius(double factor) {
  if (!m_scan) return;
  const ImageGrid& grid = m_scan->image.grid();
  m_radius->setValue(std::clamp(m_radius->value() * factor, leastRadius(grid), largestRadius(grid)));
  emit brushChanged();
}

SegmentationPanel::Surface SegmentationPanel::surface() const {
  return {m_voxel->value(), m_isSmoothed->isChecked()};
}

void SegmentationPanel::take(const ValueRange& range, bool stillDragging) {
  if (!m_scan) return;
  ValueRange taken = range;
  // Integer samples have integer ends, and no end shows insignificant digits.
  if (m_scan->image.isWhole()) {
    taken.least = std::round(taken.least);
    taken.largest = std::round(taken.largest);
  }
  taken = withoutIdleEnds(taken, m_scan->histogram.values);
  showRange(taken);
  emit rangeEdited(taken, stillDragging);
}

void SegmentationPanel::showRange(const ValueRange& range) {
  if (!m_scan) return;
  const ValueRange& all = m_scan->histogram.values;
  m_histogram->setRange(range);
  m_lower->setValue(std::clamp(range.least, all.least, all.largest));
  m_upper->setValue(std::clamp(range.largest, all.least, all.largest));
  showLabel();
}

void SegmentationPanel::fillLabels() {
  const std::vector<ImageLabel>& labels = m_scan->image.labels();
  m_labels->clear();
  m_labels->addItem(tr("All labels"));
  for (const ImageLabel& label : labels)
    m_labels->addItem(label.name.empty()
                          ? number(label.value, 9)
                          : number(label.value, 9) + QLatin1String(": ") + QString::fromStdString(label.name),
                      label.value);
  m_labels->setVisible(!labels.empty());
  m_otsu->setVisible(labels.empty());
}

// Shows the label that is the only one in the range.
void SegmentationPanel::showLabel() {
  const double least = m_lower->value(), largest = m_upper->value();
  const std::vector<ImageLabel>& labels = m_scan->image.labels();
  if (labels.empty()) return;
  const auto isIn = [&](const ImageLabel& label) { return label.value >= least && label.value <= largest; };
  const auto first = std::find_if(labels.begin(), labels.end(), isIn);
  const auto count = std::count_if(labels.begin(), labels.end(), isIn);
  const auto all = static_cast<std::ptrdiff_t>(labels.size());
  m_labels->setCurrentIndex(count == 1 && all > 1 ? static_cast<int>(first - labels.begin()) + 1
                            : count == all        ? 0
                                                  : -1);
}

// The slider is logarithmic, from one sample to the largest part.
std::size_t SegmentationPanel::debrisLimit() const {
  if (!m_figures.parts || m_figures.parts->samples().empty() || m_debris->value() == 0) return 1;
  const double largest = static_cast<double>(m_figures.parts->samples().front());
  return static_cast<std::size_t>(
      std::lround(std::pow(largest, m_debris->value() / static_cast<double>(kDebrisSteps))));
}

void SegmentationPanel::showDebris() {
  if (!m_scan || !m_figures.parts) return m_debrisText->clear();
  const std::vector<std::size_t>& samples = m_figures.parts->samples();
  const std::size_t kept = m_figures.parts->countFrom(debrisLimit());
  std::size_t lost = 0;
  for (std::size_t i = kept; i < samples.size(); ++i) lost += samples[i];
  const double sample = std::abs(m_scan->image.grid().steps.determinant());
  m_debrisText->setText(tr("Below %1 mm³: %2 of %3 parts, %4 mm³")
                            .arg(number(static_cast<double>(debrisLimit()) * sample, 3))
                            .arg(samples.size() - kept)
                            .arg(samples.size())
                            .arg(number(static_cast<double>(lost) * sample, 4)));
}

double SegmentationPanel::surfaceBytes() const {
  return m_scan && m_figures.parts ? predictedBytes(m_scan->image, m_segment, m_figures.faces, m_voxel->value()) : 0.0;
}

void SegmentationPanel::showMemory() {
  if (!m_scan || !m_figures.parts) return m_memory->clear();
  const double bytes = surfaceBytes();
  const auto left = static_cast<double>(systemMemory());
  const QString text =
      tr("About %1 MB of %2 MB available")
          .arg(QLocale().toString(std::ceil(bytes / 1e6), 'f', 0), QLocale().toString(left / 1e6, 'f', 0));
  m_memory->setText(needsConsent(bytes) ? text + QLatin1Char('\n') + tr("Larger voxels need less.") : text);
}

}  // namespace handwheel
