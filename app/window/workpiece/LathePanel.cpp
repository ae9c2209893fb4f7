// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/LathePanel.h"

#include "controls/FoldButton.h"
#include "controls/NumberField.h"
#include "window/workpiece/LatheEvents.h"
#include "window/workpiece/LatheReadout.h"
#include "window/workpiece/LatheWheels.h"
#include "window/workpiece/ToolPostRow.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPalette>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

using Do = LatheCommand::Kind;

// The directions of the automatic feed, by the ids of its buttons.
struct FeedDirection {
  LatheAxis axis;
  double sign;
};
constexpr std::array<FeedDirection, 5> kFeedDirections{{{LatheAxis::Carriage, 0.0},
                                                        {LatheAxis::Carriage, -1.0},
                                                        {LatheAxis::Carriage, 1.0},
                                                        {LatheAxis::Cross, -1.0},
                                                        {LatheAxis::Cross, 1.0}}};

NumberField* field(const QString& label, const char* name, double value, double least, double largest) {
  auto* made = new NumberField;
  made->setProblemOver();  // the panel is in use with the mouse while numbers are typed
  made->setObjectName(QString::fromLatin1(name));
  made->setQuantity(Quantity::Number, LengthUnit::Millimetre);
  made->setRange(least, largest);
  made->setValue(value);
  made->setLabel(label);
  made->setMaximumWidth(84);
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

QString number(double value, int digits) {
  return QLocale().toString(value, 'f', digits);
}

}  // namespace

// The figures are a line of their own above, so that all of it fits into 1024 pixels: levers, wheels, events. A smaller
// window shows the left part, which includes the latest event.
LathePanel::LathePanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("lathePanel"));
  auto* levers = new QVBoxLayout;
  levers->setSpacing(4);
  QWidget* const touching = makeTouchingOff();
  QWidget* const surface = makeSurfaceSpeed();
  QWidget* const thread = makeThreadAndRapid();
  for (QWidget* row : {makeReadout(), touching, makeSpindle(), surface, makeFeed(), thread}) levers->addWidget(row);
  levers->addStretch();
  m_wheels = new LatheWheels;
  connect(m_wheels, &LatheWheels::turned, this, [this](LatheAxis axis, double mm) {
    emit commanded({Do::Turn, axis, mm});
  });
  m_figures = new LatheReadout;
  m_events = new LatheEvents;
  m_latest = new QLabel;
  m_latest->setObjectName(QStringLiteral("latheLatest"));
  m_latest->setAccessibleName(tr("Latest crash or warning"));
  m_latest->setTextFormat(Qt::PlainText);
  m_latest->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_latest->setFixedHeight(fontMetrics().lineSpacing() + 2);  // also while there is none, so that nothing jumps
  auto* below = new QHBoxLayout;
  below->addLayout(levers);
  below->addWidget(m_wheels);
  below->addWidget(m_events, 1);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(8, 4, 8, 4);
  all->setSpacing(4);
  all->addWidget(m_figures);
  all->addWidget(m_latest);
  all->addWidget(rowOf({section(tr("Touching off"), "touchingOff", *touching, true),
                        section(tr("Constant surface speed"), "surfaceSpeed", *surface, false),
                        section(tr("Thread and rapid traverse"), "thread", *thread, true),
                        section(tr("Handwheels"), "wheels", *m_wheels, true)}));
  all->addLayout(below);
}

// A heading that folds its section; it keeps its state.
QWidget* LathePanel::section(const QString& title, const char* name, QWidget& content, bool isOpenAtFirst) {
  const QString key = QStringLiteral("lathePanel/") + QLatin1String(name);
  auto* const heading = new FoldButton(title, QSettings().value(key, isOpenAtFirst).toBool());
  heading->setObjectName(QStringLiteral("latheSection/") + QLatin1String(name));
  if (!heading->isOpen()) content.hide();
  connect(heading, &FoldButton::toggledOpen, this, [this, key, &content](bool isOpen) {
    content.setVisible(isOpen);
    QSettings().setValue(key, isOpen);
    emit folded();
  });
  return heading;
}

QPushButton* LathePanel::button(const QString& text, const char* name, const QString& tip) {
  auto* made = new QPushButton(text);
  made->setObjectName(QString::fromLatin1(name));
  made->setToolTip(tip);
  return made;
}

QWidget* LathePanel::makeReadout() {
  m_post = new ToolPostRow;
  m_x = new QLabel;
  m_x->setObjectName(QStringLiteral("latheX"));
  m_z = new QLabel;
  m_z->setObjectName(QStringLiteral("latheZ"));
  const auto widest = [this](const QString& axis, const QString& read) {
    return std::max(fontMetrics().horizontalAdvance(tr("%1 not touched off").arg(axis)),
                    fontMetrics().horizontalAdvance(read));
  };
  m_x->setMinimumWidth(widest(QStringLiteral("X"), QStringLiteral("X ⌀ -888.888 mm")));
  m_z->setMinimumWidth(widest(QStringLiteral("Z"), QStringLiteral("Z -888.888 mm")));
  connect(m_post, &ToolPostRow::sideChosen, this, [this](int side) {
    emit commanded({Do::Tool, LatheAxis::Carriage, static_cast<double>(side)});
  });
  connect(m_post, &ToolPostRow::mountRequested, this, &LathePanel::mountRequested);
  auto* const row = rowOf({m_post, m_x, m_z});
  static_cast<QHBoxLayout*>(row->layout())->setStretch(0, 1);
  return row;
}

QWidget* LathePanel::makeTouchingOff() {
  m_touch = field(tr("Value for touching off, mm"), "latheTouchValue", 0.0, -1e4, 1e4);
  m_touchX = button(tr("Touch off &X"), "latheTouchX", tr("The read-out shows this value for X here"));
  auto* const offZ = button(tr("Touch off &Z"), "latheTouchZ", tr("The read-out shows this value for Z here"));
  connect(m_touchX, &QPushButton::clicked, this, [this] { emit touchOffRequested(true, m_touch->value()); });
  connect(offZ, &QPushButton::clicked, this, [this] { emit touchOffRequested(false, m_touch->value()); });
  return rowOf({m_touch, new QLabel(tr("mm")), m_touchX, offZ});
}

QWidget* LathePanel::makeSpindle() {
  m_spindle = new QButtonGroup(this);
  const auto directionButton = [&](int direction, const QString& text, const char* name) {
    QPushButton* const made = button(text, name, tr("Direction of the spindle"));
    made->setCheckable(true);
    m_spindle->addButton(made, direction + 1);
    return made;
  };
  m_speed = field(tr("Speed, r/min"), "latheSpeed", 600.0, 1.0, 10'000.0);
  connect(m_spindle, &QButtonGroup::idClicked, this, [this](int id) {
    emit commanded({Do::Spindle, LatheAxis::Carriage, id - 1.0});
  });
  connect(m_speed, &NumberField::valueEdited, this, &LathePanel::sendSpeed);
  return rowOf({new QLabel(tr("Spindle")), directionButton(1, tr("&Forward"), "latheForward"),
                directionButton(0, tr("&Stop"), "latheStop"), directionButton(-1, tr("&Reverse"), "latheReverse"),
                m_speed, new QLabel(tr("r/min"))});
}

QWidget* LathePanel::makeSurfaceSpeed() {
  m_isConstant = new QCheckBox(tr("Constant"));
  m_isConstant->setObjectName(QStringLiteral("latheConstantSpeed"));
  m_isConstant->setToolTip(tr("Constant surface speed: the spindle turns faster the nearer the tool is to the axis"));
  m_surface = field(tr("Surface speed, m/min"), "latheSurfaceSpeed", 100.0, 1.0, 2'000.0);
  m_clamp = field(tr("Largest speed, r/min"), "latheClamp", 2'000.0, 1.0, 10'000.0);
  connect(m_isConstant, &QCheckBox::toggled, this, &LathePanel::sendSpeed);
  for (NumberField* each : {m_surface, m_clamp}) connect(each, &NumberField::valueEdited, this, &LathePanel::sendSpeed);
  return rowOf({m_isConstant, m_surface, new QLabel(tr("m/min, at most")), m_clamp, new QLabel(tr("r/min"))});
}

QWidget* LathePanel::makeFeed() {
  m_feedDirections = new QButtonGroup(this);
  const auto feedButton = [&](int id, const QString& text, const char* name, const QString& tip) {
    QPushButton* const made = button(text, name, tip);
    made->setAccessibleName(tip);
    made->setCheckable(true);
    made->setMaximumWidth(fontMetrics().horizontalAdvance(text) + 28);
    m_feedDirections->addButton(made, id);
    return made;
  };
  m_feed = field(tr("Feed, mm in a turn"), "latheFeed", 0.1, 0.0, 10.0);
  connect(m_feedDirections, &QButtonGroup::idClicked, this, &LathePanel::sendFeed);
  connect(m_feed, &NumberField::valueEdited, this, [this] { sendFeed(m_feedDirections->checkedId()); });
  return rowOf({new QLabel(tr("Feed")), feedButton(0, tr("Off"), "latheFeedOff", tr("No automatic feed")),
                feedButton(1, tr("To chuck"), "latheFeedLeft", tr("Automatic feed of the carriage to the chuck")),
                feedButton(2, tr("Away"), "latheFeedRight", tr("Automatic feed of the carriage away from the chuck")),
                feedButton(3, tr("In"), "latheFeedIn", tr("Automatic feed of the cross slide to the axis")),
                feedButton(4, tr("Out"), "latheFeedOut", tr("Automatic feed of the cross slide outward")), m_feed,
                new QLabel(tr("mm/rev"))});
}

QWidget* LathePanel::makeThreadAndRapid() {
  m_lead = field(tr("Pitch of the thread, mm"), "latheLead", 1.5, 0.0, 100.0);
  m_nut = button(tr("&Half-nut"), "latheHalfNut", tr("Closes the half-nut: the carriage follows the lead screw"));
  m_nut->setCheckable(true);
  m_isLeft =
      button(tr("&Left-hand"), "latheLeftHand",
             tr("Left-hand thread: while the spindle runs forward the lead screw takes the carriage away from the "
                "chuck. It is set while the half-nut is open."));
  m_isLeft->setCheckable(true);
  m_isLeft->setMaximumWidth(fontMetrics().horizontalAdvance(m_isLeft->text()) + 20);
  connect(m_nut, &QPushButton::clicked, this, [this](bool isClosed) {
    const double lead = m_isLeft->isChecked() ? m_lead->value() : -m_lead->value();
    emit commanded({Do::HalfNut, LatheAxis::Carriage, isClosed ? lead : 0.0});
  });
  const auto hold = [this](const QString& text, const char* name, const QString& tip, LatheAxis axis,
                           double direction) {
    QPushButton* const made = button(text, name, tip);
    made->setAccessibleName(tip);
    made->setMaximumWidth(fontMetrics().horizontalAdvance(text) + 28);
    connect(made, &QPushButton::pressed, this, [this, axis, direction] {
      emit commanded({Do::Rapid, axis, direction});
    });
    connect(made, &QPushButton::released, this, [this, axis] { emit commanded({Do::Rapid, axis, 0.0}); });
    return made;
  };
  return rowOf(
      {new QLabel(tr("Thread, pitch")), m_lead, new QLabel(tr("mm")), m_isLeft, m_nut, new QLabel(tr("Rapid")),
       hold(QStringLiteral("←"), "latheRapidLeft", tr("Rapid traverse to the chuck, while held (Alt+←)"),
            LatheAxis::Carriage, -1.0),
       hold(QStringLiteral("→"), "latheRapidRight", tr("Rapid traverse away from the chuck, while held (Alt+→)"),
            LatheAxis::Carriage, 1.0),
       hold(QStringLiteral("↑"), "latheRapidIn", tr("Rapid traverse in, while held (Alt+↑)"), LatheAxis::Cross, -1.0),
       hold(QStringLiteral("↓"), "latheRapidOut", tr("Rapid traverse out, while held (Alt+↓)"), LatheAxis::Cross,
            1.0)});
}

// A read-out as that of a lathe whose axis has no reference shows no number that could be taken for a size.
void LathePanel::showAxis(QLabel& label, const QString& axis, const QString& read, const QString& meaning,
                          const QString& remedy) {
  const QString text = read.isEmpty() ? tr("%1 not touched off").arg(axis) : read;
  if (label.text() == text) return;
  label.setText(text);
  label.setToolTip(read.isEmpty() ? tr("%1 has no zero yet. %2").arg(axis, remedy) : meaning);
  label.setEnabled(!read.isEmpty());  // greyed
}

void LathePanel::sendSpeed() {
  if (m_isConstant->isChecked())
    emit commanded({Do::SurfaceSpeed, LatheAxis::Carriage, m_surface->value(), m_clamp->value()});
  else
    emit commanded({Do::Speed, LatheAxis::Carriage, m_speed->value()});
}

void LathePanel::sendFeed(int direction) {
  if (direction < 0 || direction >= static_cast<int>(kFeedDirections.size())) return;
  const FeedDirection& chosen = kFeedDirections[static_cast<std::size_t>(direction)];
  emit commanded({Do::Feed, chosen.axis, chosen.sign * m_feed->value()});
}

void LathePanel::show(const ManualLatheTool& tool) {
  const auto now = tool.moment();
  const ProfilePoint read = tool.readout();
  const QString badge = tool.setup().showsDiameter ? QStringLiteral("⌀") : QStringLiteral("R");
  m_touchX->setText(tr("Touch off &X") + QLatin1Char(' ') + badge);
  const auto [hasX, hasZ] = tool.isTouchedOff();
  showAxis(
      *m_x, QStringLiteral("X"), hasX ? QStringLiteral("X %1 %2 mm").arg(badge, number(read.x(), 3)) : QString(),
      tool.setup().showsDiameter
          ? tr("Diameter at the tip, from the workpiece zero as it was touched off; outward is positive")
          : tr("Radius at the tip, from the workpiece zero as it was touched off; outward is positive"),
      tr("Turn a little of the bar, measure its diameter, enter it below, and press “Touch off X” before the cross "
         "slide moves."));
  showAxis(*m_z, QStringLiteral("Z"), hasZ ? QStringLiteral("Z %1 mm").arg(number(read.y(), 3)) : QString(),
           tr("From the workpiece zero as it was touched off; away from the chuck is positive"),
           tr("Touch the face of the bar with the tool, enter its height below, and press “Touch off Z” before the "
              "carriage moves."));
  if (QAbstractButton* const shown = m_spindle->button(now->machine.direction + 1)) shown->setChecked(true);
  int direction = 0;
  for (std::size_t i = 1; now->machine.feed != 0.0 && i < kFeedDirections.size(); ++i) {
    if (kFeedDirections[i].axis == now->machine.feedAxis && kFeedDirections[i].sign * now->machine.feed > 0.0)
      direction = static_cast<int>(i);
  }
  m_feedDirections->button(direction)->setChecked(true);
  m_nut->setChecked(now->machine.lead != 0.0);
  m_isLeft->setEnabled(now->machine.lead == 0.0);
  m_post->show(tool);
  m_wheels->show(tool);
  m_figures->show(tool);
  m_events->show(tool);
  const QListWidgetItem* const latest = m_events->item(m_events->count() - 1);
  const QString text = latest ? latest->text() : QString();
  if (m_latest->text() == text) return;
  m_latest->setText(text);
  m_latest->setToolTip(text);
  QPalette colours = palette();
  if (latest && latest->foreground().style() != Qt::NoBrush)
    colours.setBrush(QPalette::WindowText, latest->foreground());
  m_latest->setPalette(colours);
}

void LathePanel::begin(const ManualLatheTool& tool, const std::optional<LatheWheels::Rings>& rings, double touch) {
  const auto now = tool.moment();
  const LatheState& machine = now->machine;
  const QSignalBlocker noCommand(m_isConstant);
  m_speed->setValue(machine.setSpeed);
  m_isConstant->setChecked(machine.surfaceSpeed > 0.0);
  if (machine.surfaceSpeed > 0.0) m_surface->setValue(machine.surfaceSpeed);
  if (machine.speedClamp > 0.0) m_clamp->setValue(machine.speedClamp);
  if (machine.feed != 0.0) m_feed->setValue(std::abs(machine.feed));
  if (machine.lead != 0.0) m_lead->setValue(std::abs(machine.lead));
  m_isLeft->setChecked(machine.lead > 0.0);
  m_touch->setValue(touch);
  m_wheels->setRings(tool, rings);
  show(tool);
}

double LathePanel::touchValue() const {
  return m_touch->value();
}

}  // namespace handwheel
