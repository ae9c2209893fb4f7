// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/HoleSettings.h"

#include "controls/NumberField.h"
#include "panels/ActionButton.h"
#include "text/RepairText.h"

#include <QAbstractItemView>
#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QStyle>
#include <QToolButton>

namespace handwheel {

namespace {

constexpr FillMethod kMethods[] = {FillMethod::Fair, FillMethod::Refined,  FillMethod::Ear,    FillMethod::Minimal,
                                   FillMethod::Area, FillMethod::Dihedral, FillMethod::Crease, FillMethod::Flat};

QComboBox* methodBox(QWidget* parent) {
  auto* box = new QComboBox(parent);
  box->setObjectName(QStringLiteral("fillMethod"));
  box->setAccessibleName(HoleSettings::tr("Fill method"));
  for (FillMethod method : kMethods) {
    box->addItem(fillMethodName(method), static_cast<int>(method));
    box->setItemData(box->count() - 1, fillMethodHint(method), Qt::ToolTipRole);
  }
  // A box that needs more room than a narrow panel has would make Qt lay out the texts above it for a wider panel.
  constexpr int kFewestLetters = 5;
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(kFewestLetters);
  constexpr int kPadding = 24;  // padding of the items, by the style sheet
  box->view()->setMinimumWidth(box->view()->sizeHintForColumn(0) + kPadding);
  return box;
}

// Creates a check box for a checkable action.
QCheckBox* checkBoxFor(QAction* action, QWidget* parent) {
  auto* box = new QCheckBox(action->iconText(), parent);
  box->setObjectName(action->objectName() + QStringLiteral("Check"));
  box->setToolTip(action->toolTip());
  box->setChecked(action->isChecked());
  QObject::connect(box, &QCheckBox::clicked, action, &QAction::trigger);
  QObject::connect(action, &QAction::toggled, box, &QCheckBox::setChecked);
  return box;
}

}  // namespace

HoleSettings::HoleSettings(QAction* fill, QAction* keepOpen, QAction* preview, QAction* thickenSheet,
                           QAction* cutAndClose, QWidget* parent)
    : QFrame(parent),
      m_name(new QLabel(this)),
      m_detail(new QLabel(this)),
      m_measures(new QLabel(this)),
      m_method(methodBox(this)),
      m_status(new QLabel(this)),
      m_otherStatus(new QLabel(this)),
      m_trials(new MethodTable(this)),
      m_thickness(new NumberField(this)) {
  setObjectName(QStringLiteral("holeSettings"));
  m_name->setProperty("strong", true);
  m_detail->setProperty("muted", true);
  m_detail->setWordWrap(true);
  m_detail->setAlignment(Qt::AlignRight | Qt::AlignTop);
  m_measures->setObjectName(QStringLiteral("holeMeasures"));
  m_measures->setProperty("muted", true);
  m_status->setProperty("muted", true);
  m_status->setObjectName(QStringLiteral("previewStatus"));
  m_otherStatus->setProperty("muted", true);
  m_otherStatus->setObjectName(QStringLiteral("otherPreviewStatus"));
  for (QLabel* label : {m_measures, m_status, m_otherStatus}) label->setWordWrap(true);
  keepRoomForOther(true);
  m_otherStatus->setMinimumHeight(2 * m_otherStatus->fontMetrics().lineSpacing());
  showOtherPreview({});
  m_status->setMinimumHeight(m_status->fontMetrics().lineSpacing());
  auto* methodLabel = new QLabel(tr("Method"), this);
  methodLabel->setBuddy(m_method);

  auto* title = new QHBoxLayout;
  title->addWidget(m_name, 0, Qt::AlignTop);
  title->addWidget(m_detail, 1);
  auto* method = new QHBoxLayout;
  method->setSpacing(8);
  method->addWidget(methodLabel);
  method->addWidget(m_method, 1);
  method->addWidget(compareButton());
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  buttons->addWidget(new ActionButton(keepOpen, ActionButton::Rank::Ordinary, this), 1);
  buttons->addWidget(new ActionButton(fill, ActionButton::Rank::Primary, this), 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(8);
  column->addLayout(title);
  column->addWidget(m_measures);
  column->addLayout(method);
  column->addWidget(m_trials);
  column->addWidget(checkBoxFor(preview, this));
  column->addWidget(m_status);
  column->addLayout(buttons);
  const auto addWhenPossible = [column](QWidget* widget, QAction* action) {
    const auto follow = [widget, action] { widget->setVisible(action->isVisible() && action->isEnabled()); };
    connect(action, &QAction::changed, widget, follow);
    follow();
    column->addWidget(widget);
  };
  addWhenPossible(thicknessRow(), thickenSheet);
  auto* thicken = new ActionButton(thickenSheet, ActionButton::Rank::Ordinary, this);
  connect(thicken, &ActionButton::pointed, this, &HoleSettings::thickeningPointed);
  addWhenPossible(thicken, thickenSheet);
  addWhenPossible(new ActionButton(cutAndClose, ActionButton::Rank::Ordinary, this), cutAndClose);
  column->addWidget(m_otherStatus);

  connect(m_method, &QComboBox::currentIndexChanged, this, [this] {
    m_method->setToolTip(fillMethodHint(this->method()));
    m_trials->showChosen(this->method());
    emit methodChanged(this->method());
  });
  m_method->setToolTip(fillMethodHint(FillMethod::Fair));
  connect(m_trials, &MethodTable::methodChosen, this, &HoleSettings::setMethod);
}

QToolButton* HoleSettings::compareButton() {
  auto* button = new QToolButton(this);
  button->setObjectName(QStringLiteral("compareMethods"));
  button->setText(tr("Compare"));
  button->setToolTip(tr("Show the result of each method for this hole"));
  button->setCheckable(true);
  m_trials->hide();
  connect(button, &QToolButton::toggled, this, [this](bool on) {
    m_trials->setVisible(on);
    keepRoomForOther(!on);  // the last methods would not fit on a small screen
    if (on) emit compareRequested();
  });
  return button;
}

// The label keeps its room, so that the button under the pointer does not move when the text appears.
void HoleSettings::keepRoomForOther(bool isKept) {
  QSizePolicy policy = m_otherStatus->sizePolicy();
  policy.setRetainSizeWhenHidden(isKept);
  m_otherStatus->setSizePolicy(policy);
}

QWidget* HoleSettings::thicknessRow() {
  auto* row = new QWidget(this);
  auto* label = new QLabel(tr("Thickness"), row);
  label->setBuddy(m_thickness);
  m_thickness->setObjectName(QStringLiteral("sheetThickness"));
  m_thickness->setLabel(label->text());
  m_thickness->setToolTip(
      tr("Thickness of the sheet's thin body, which grows to the side opposite to the normals: the triangles of the "
         "sheet stay where they are. Less where that would intersect anything; the log says what was reached."));
  constexpr double kLeast = 1e-9, kMost = 1e9;  // mm, the range of the operation
  m_thickness->setRange(kLeast, kMost);
  auto* fields = new QHBoxLayout(row);
  fields->setContentsMargins(0, 0, 0, 0);
  fields->setSpacing(8);
  fields->addWidget(label);
  fields->addWidget(m_thickness, 1);
  connect(m_thickness, &NumberField::valueEdited, this, [this](double value) { emit thicknessEdited(value); });
  return row;
}

void HoleSettings::showThickness(double thickness, LengthUnit unit) {
  m_thickness->setQuantity(Quantity::Length, unit);
  m_thickness->setValue(thickness);
}

bool HoleSettings::isComparing() const {
  return m_trials->isVisibleTo(this);
}

void HoleSettings::showTrials(const std::vector<MethodTrial>& trials) {
  m_trials->showTrials(trials);
  m_trials->showChosen(method());
}

std::span<const FillMethod> HoleSettings::methods() {
  return kMethods;
}

FillMethod HoleSettings::method() const {
  return static_cast<FillMethod>(m_method->currentData().toInt());
}

void HoleSettings::setMethod(FillMethod method) {
  m_method->setCurrentIndex(m_method->findData(static_cast<int>(method)));
}

void HoleSettings::showLoop(const QString& name, const QString& detail, const QString& measures) {
  m_measures->setText(measures);
  m_name->setText(name);
  m_detail->setText(detail);
}

void HoleSettings::showOtherPreview(const QString& text) {
  m_otherStatus->setText(text);
  m_otherStatus->setVisible(!text.isEmpty());
}

void HoleSettings::showPreview(const PreviewState& state) {
  m_status->setProperty("bad", state.kind == PreviewState::Kind::Failed);
  m_status->style()->polish(m_status);  // the style sheet colours errors
  switch (state.kind) {
    case PreviewState::Kind::Off:
      return m_status->clear();
    case PreviewState::Kind::Working:
      return m_status->setText(tr("Computing the patch…"));
    case PreviewState::Kind::Failed:
      return m_status->setText(tr("Cannot be filled: %1.").arg(fillFailureReason(state.failure)));
    case PreviewState::Kind::Ready:
      break;
  }
  QStringList lines{tr("%Ln new triangle(s)", nullptr, static_cast<int>(state.triangles))};
  if (state.substitute != Substitute::None) lines << substituteText(state.substitute, state.method);
  const QString warning = patchWarning(state.shape);
  if (!warning.isEmpty()) lines << tr("Check the patch: %1.").arg(warning);
  m_status->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace handwheel
